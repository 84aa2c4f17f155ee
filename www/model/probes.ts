// The probes of the Identify view, and observations as texts by name.
import type { Field, Probe, ProbeKind } from "../engine.ts";

/** More observations than this are not read. */
export const mostObservations = 16;

/** The order in which they are offered. */
export const kinds = [
  ...(["product", "rotate", "matrix", "from-matrix"] as const),
  ...(["components", "quarter-turn", "perturb"] as const),
] satisfies ProbeKind[];

/** The texts that an observation may have. */
export type TextName =
  | "a"
  | "b"
  | "quaternion"
  | "vector"
  | "matrix"
  | "rotationVector"
  | "printed";

/** What goes into a probe, in the order of its call. */
export const inputsOf: Record<ProbeKind, readonly TextName[]> = {
  product: ["a", "b"],
  rotate: ["quaternion", "vector"],
  matrix: ["quaternion"],
  "from-matrix": ["matrix"],
  components: ["quaternion"],
  "quarter-turn": [],
  perturb: ["quaternion", "rotationVector"],
};

/** As the core names it in a problem. */
export const fieldOf: Record<TextName, Field> = {
  a: "a",
  b: "b",
  quaternion: "quaternion",
  vector: "vector",
  matrix: "matrix",
  rotationVector: "rotation-vector",
  printed: "printed",
};

export function textOf(probe: Probe, name: TextName): string {
  const texts: Partial<Record<TextName, string>> = probe;
  return texts[name] ?? "";
}

export function withText(probe: Probe, name: TextName, text: string): Probe {
  return { ...probe, [name]: text };
}

/** Whether the same was tried, whatever came out. */
export function isSameProbe(one: Probe, other: Probe): boolean {
  return (
    one.probe === other.probe &&
    inputsOf[one.probe].every((name) => textOf(one, name) === textOf(other, name))
  );
}
