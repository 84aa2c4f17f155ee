// What is said of the behaviour of libraries; the same in the picker, the table and the translation.
import type {
  AngleUnit,
  AxisAngleSign,
  Direction,
  EndNumbers,
  Family,
  Group,
  HalfTurns,
  Known,
  Language,
  NonUnitResult,
  RecordKind,
  RecordNumbers,
  RecordNumbersKind,
  SignChoice,
  SlerpWay,
  VectorLayout,
  ZeroResult,
} from "../engine.ts";

export const groupNames: Record<Group, string> = {
  robotics: "Robotics",
  estimation: "Estimation",
  simulation: "Simulation",
  graphics: "Graphics and games",
  aerospace: "Aircraft and spacecraft",
  mathematics: "Mathematics",
  devices: "Formats and devices",
};

/** What a record is of, where that is no library. */
export const kindNames: Record<RecordKind, string> = { format: "format", device: "device" };
export const libraryKind = "library";

/** What stands for a rotation where no quaternion does. */
export const numbersNames: Record<RecordNumbersKind, string> = {
  "euler-angles": "Euler angles",
  "rotation-vector": "rotation vector",
  "axis-angle": "axis and angle",
  matrix: "matrix",
};

/** `A B C`, `rotation vector`; of angles with long names, what they are. */
export function numbersCalled({ kind, names = "" }: RecordNumbers | EndNumbers): string {
  return kind === "euler-angles" && hasShortNames(names) ? names : numbersNames[kind];
}

/** Whether names fit into a column: `roll pitch yaw` do. */
export const hasShortNames = (names: string | undefined) =>
  names !== undefined && names !== "" && names.length <= 14;

export const inUnit = (unit: AngleUnit | undefined) => (unit === undefined ? "" : ` in ${unit}`);

/** `A B C in degrees`, `rotation vector in radians`, `matrix`. */
export const numbersWords = (numbers: RecordNumbers | EndNumbers) =>
  numbersCalled(numbers) + inUnit(numbers.unit);

/** How numbers make the rotation: `Rz(A) Ry(B) Rx(C)`, with the names that they have, or a, b, c. */
export function meansWords({ means = "", names = "" }: Pick<RecordNumbers, "means" | "names">) {
  const name = (letter: string) => names.split(" ")["abc".indexOf(letter)] || letter;
  return means.replace(/[abc](?=\))/g, (letter) => name(letter)).replaceAll("-", "−");
}

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

/** What an end of a translation is called that has no other name. */
export const customConvention = "Custom convention";

/** `constructor: kept, matrix: normalised`; empty where nothing is established. */
export function resultWords<Result extends string>(
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
