// The probes that the core proposes.
import type { Engine, Language, NextProbe, ProbeKind } from "../../engine.ts";
import { kinds } from "../../model/probes.ts";

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
