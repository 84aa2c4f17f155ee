// Observations in the address: `product;0 1 0 0;0 0 1 0;0 0 0 1`, one parameter each.
import type { MatrixLayout, Probe } from "../engine.ts";
import { matrixLayoutValues, probeKindValues } from "../values.ts";

const mark = ";";

/** A text without the mark, from which it reads back. */
const escaped = (text: string) => text.replaceAll("~", "~0").replaceAll(mark, "~1");
const unescaped = (text: string) => text.replaceAll("~1", mark).replaceAll("~0", "~");

export function probeToText(probe: Probe): string {
  return [probe.probe, ...partsOf(probe)].map(escaped).join(mark);
}

function partsOf(probe: Probe): string[] {
  switch (probe.probe) {
    case "components":
      return [probe.quaternion, probe.printed];
    case "product":
      return [probe.a, probe.b, probe.printed];
    case "rotate":
      return [probe.quaternion, probe.vector, probe.printed];
    case "matrix":
      return [probe.quaternion, probe.printed, ...layoutPart(probe.layout)];
    case "from-matrix":
      return [probe.matrix, probe.printed, ...layoutPart(probe.layout)];
    case "quarter-turn":
      return [probe.printed];
    case "perturb":
      return [probe.quaternion, probe.rotationVector, probe.printed];
  }
}

/** Row by row is left out. */
const layoutPart = (layout: MatrixLayout = "as-written") =>
  layout === "as-written" ? [] : [layout];

/** Nothing for a text that is no observation. */
export function probeFromText(text: string): Probe | undefined {
  const [kind, first = "", second = "", third = ""] = text.split(mark).map(unescaped);
  switch (probeKindValues.find((name) => name === kind)) {
    case "components":
      return { probe: "components", quaternion: first, printed: second };
    case "product":
      return { probe: "product", a: first, b: second, printed: third };
    case "rotate":
      return { probe: "rotate", quaternion: first, vector: second, printed: third };
    case "matrix":
      return { probe: "matrix", quaternion: first, printed: second, layout: layoutFrom(third) };
    case "from-matrix":
      return { probe: "from-matrix", matrix: first, printed: second, layout: layoutFrom(third) };
    case "quarter-turn":
      return { probe: "quarter-turn", printed: first };
    case "perturb":
      return { probe: "perturb", quaternion: first, rotationVector: second, printed: third };
    case undefined:
      return undefined;
  }
}

const layoutFrom = (text: string): MatrixLayout =>
  matrixLayoutValues.find((layout) => layout === text) ?? "as-written";
