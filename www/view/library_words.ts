// The words for what libraries do; the same in the picker, the table and the translation.
import type {
  AxisAngleSign,
  ComponentOrder,
  Direction,
  Endpoint,
  Engine,
  Family,
  Group,
  HalfTurns,
  Known,
  Language,
  Library,
  NonUnitResult,
  SignChoice,
  SlerpWay,
  TranslatedEnd,
  VectorLayout,
  ZeroResult,
} from "../engine.ts";
import { lettersOf, nameOf } from "./words.ts";

export const groupNames: Record<Group, string> = {
  robotics: "Robotics",
  estimation: "Estimation",
  simulation: "Simulation",
  graphics: "Graphics and games",
  aerospace: "Aircraft and spacecraft",
  mathematics: "Mathematics",
  devices: "Devices and formats",
};
export const groups = Object.keys(groupNames) as Group[];

export const languageNames: Record<Language, string> = {
  python: "Python",
  cpp: "C++",
  c: "C",
  rust: "Rust",
  javascript: "JavaScript",
  java: "Java",
  csharp: "C#",
  swift: "Swift",
  matlab: "MATLAB",
  message: "message",
};

/** How a behaviour is known: in a word, and in a sentence. */
export const knownWords: Record<Known, [string, string]> = {
  run: ["run", "It was run, and printed the numbers that are recorded here."],
  read: ["source read", "Its source was read; it was not run."],
  documented: ["documented", "Only what its documentation says; it was not run."],
};

export const notEstablished = "not established";

export const productWords = { right: "ij = k", left: "ij = −k" } as const;

export const vectorWords: Record<VectorLayout, string> = {
  column: "for column vectors M v",
  row: "for row vectors v M",
};

export const takesWords: Record<Direction, string> = {
  "body-to-world": "body coordinates to world coordinates",
  "world-to-body": "world coordinates to body coordinates",
};

/** How product and rotation belong together: in a few words, and what follows from it. */
export const familyWords: Record<Family, [string, string]> = {
  hamilton: ["Hamilton", "ij = k with R(q), as the label says"],
  shuster: ["JPL (Shuster)", "ij = −k with C(q), as the label JPL says"],
  "reversed-product": [
    "not JPL: Shuster product, but R(q)",
    "ij = −k, and yet it rotates as Hamilton's does: the operands stand the other way round",
  ],
  "transposed-matrix": [
    "not Hamilton: Hamilton product, but C(q)",
    "ij = k, and yet it acts as JPL's does: the operands stand the other way round",
  ],
};

/** The accent of a family: the two labels have one, the others none. */
export function accentOf(family: Family | undefined): "hamilton" | "jpl" | "custom" {
  if (family === "hamilton") return "hamilton";
  return family === "shuster" ? "jpl" : "custom";
}

export const nonUnitWords: Record<NonUnitResult, string> = {
  kept: "kept",
  normalised: "normalised",
  scaled: "scaled by the norm²",
  distorted: "distorted",
  changed: "changed",
  refused: "refused",
};

export const zeroWords: Record<ZeroResult, string> = {
  kept: "kept",
  identity: "identity",
  "minus-identity": "minus the identity",
  "half-turn": "half a turn",
  zero: "zeros",
  nan: "NaN",
  refused: "refused",
  other: "something else",
};

export const signWords: Record<SignChoice, string> = {
  "scalar-non-negative": "the scalar is not negative",
  "largest-positive": "the largest component is positive, so the scalar can be negative",
  mixed: "no rule that the runs show",
};

export const halfTurnWords: Record<HalfTurns, string> = {
  right: "half turns come back right",
  wrong: "some half turns come back wrong",
};

export const slerpWords: Record<SlerpWay, string> = {
  short: "the shorter way",
  long: "as the signs say, even the longer way",
};

export const axisAngleWords: Record<AxisAngleSign, string> = {
  positive: "+z: (cos θ/2, sin θ/2 n)",
  negative: "−z: the conjugate of (cos θ/2, sin θ/2 n)",
};

export function libraryWith(engine: Engine, id: string | undefined): Library | undefined {
  return engine.libraries.find((library) => library.id === id);
}

/** What an end is called. */
export function endName(end: Endpoint, engine: Engine): string {
  if (end.kind === "library") return libraryWith(engine, end.id)?.name ?? end.id;
  return nameOf(end.convention, engine) ?? "Custom convention";
}

/** The order of a record: that of its array, or else of its constructor. */
export function orderOf(library: Library): ComponentOrder | undefined {
  return library.array ?? library.constructor;
}

/** The orders in which four numbers of a library stand: one, two, or none that is established. */
export function ordersOf(library: Library): ComponentOrder[] {
  return [...new Set([library.array, library.constructor])].filter((order) => order !== undefined);
}

/** What is established of the way a library acts; nothing that the core assumed. */
export function establishedOf(end: TranslatedEnd | undefined) {
  const acts = end !== undefined && !end.assumed.includes("action");
  return {
    action: acts ? end.action : undefined,
    family: acts ? end.family : undefined,
    first: acts ? end.firstToAct : undefined,
  };
}

/** `x y z w, Hamilton · 1.17.1, run`. */
export function aboutLibrary(library: Library, engine: Engine): string {
  const { family } = establishedOf(engine.endOf(library.id));
  const orders = ordersOf(library).map((order) => lettersOf[order]);
  const behaviour = [orders.join(" / "), family && familyWords[family][0]].filter(Boolean);
  const known = `${library.version}, ${knownWords[library.known][0]}`;
  return behaviour.length === 0 ? known : `${behaviour.join(", ")} · ${known}`;
}

/** `constructor: kept, matrix: normalised`; empty where nothing is established. */
export function listed<Result extends string>(
  results: object | undefined,
  words: Record<Result, string>,
): string {
  return Object.entries((results ?? {}) as Record<string, Result | undefined>)
    .flatMap(([what, result]) => (result === undefined ? [] : [`${whats[what]} ${words[result]}`]))
    .join(", ");
}

const whats: Record<string, string> = {
  construct: "constructor:",
  matrix: "matrix:",
  rotate: "rotated vector:",
  normalize: "normalised:",
  inverse: "inverse:",
};
