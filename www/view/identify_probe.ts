// Observations as texts by name, and the probes that the core proposes; pure but for the core.
import type { Engine, Field, Language, NextProbe, Probe, ProbeKind } from "../engine.ts";
import { kinds } from "./identify_choices.ts";

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

const proposed = new WeakMap<Engine, Map<string, NextProbe | undefined>>();

/** The probe of a kind as the core proposes it, with its code: what it asks when it can ask no other. */
export function standardProbe(
  engine: Engine,
  kind: ProbeKind,
  language: Language,
): NextProbe | undefined {
  const known = proposed.get(engine) ?? new Map<string, NextProbe | undefined>();
  proposed.set(engine, known);
  const key = `${kind} ${language}`;
  if (!known.has(key)) {
    const unavailable = kinds.filter((other) => other !== kind);
    const answer = engine.analyze({ view: "identify", observations: [], language, unavailable });
    known.set(key, answer.status === "identify" ? answer.next : undefined);
  }
  return known.get(key);
}
