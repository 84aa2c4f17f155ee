// The words of the Identify view: what a probe asks, what a choice is called, what to check.

import type { Preset } from "../address.ts";
import type {
  BehaviourAxis,
  ComponentOrder,
  ComponentSign,
  CosineMatrix,
  Family,
  Handedness,
  Language,
  Perturbation,
  ProbeKind,
  Remaining,
  Side,
} from "../engine.ts";
import { languageNames, productWords } from "./library_words.ts";
import { lettersOf } from "./words.ts";

/** What each probe is called and asks. */
export const probeWords: Record<ProbeKind, { name: string; asks: string }> = {
  product: {
    name: "a product",
    asks: "What is a * b? Of two units, the place tells the order and the sign tells the product.",
  },
  rotate: {
    name: "a rotated vector",
    asks: "Where does q take the vector x, by the call that rotates?",
  },
  matrix: { name: "the matrix of q", asks: "Which nine numbers are its matrix of q?" },
  "from-matrix": {
    name: "the quaternion of a matrix",
    asks: "Which quaternion does it make of the matrix M?",
  },
  components: {
    name: "four numbers, printed back",
    asks: "In which order do four different numbers come back out of the constructor?",
  },
  "quarter-turn": {
    name: "a body turned by a quarter",
    asks: "Turn the body by +90° about the world's z axis: which quaternion is its attitude?",
  },
  perturb: {
    name: "a small turn added",
    asks: "What is q after the small turn φ of the body was added, in radians?",
  },
};

/** The order in which they are offered. */
export const kinds = [
  ...(["product", "rotate", "matrix", "from-matrix"] as const),
  ...(["components", "quarter-turn", "perturb"] as const),
] satisfies ProbeKind[];

/** Languages of code lines; a message has none of its own. */
export const codeLanguages = (Object.keys(languageNames) as Language[]).filter(
  (language) => language !== "message",
);

interface Values {
  constructor: ComponentOrder;
  array: ComponentOrder;
  handedness: Handedness;
  rotate: CosineMatrix;
  matrix: CosineMatrix;
  attitude: ComponentSign;
  perturbation: Perturbation;
}

/** What a value is called, and the convention that has it. */
export interface ValueWords {
  value: string;
  words: string;
  preset?: Preset;
}

/** The name of a choice, and as what it is settled or disputed. */
interface ChoiceWords<Value extends string> {
  name: string;
  about: string;
  values: readonly [ValueWords & { value: Value }, ValueWords & { value: Value }];
}

/** In one line. */
const unbroken = (text: string) => text.replaceAll(" ", "\u00a0");

const orders = [
  { value: "scalar-first", words: lettersOf["scalar-first"] },
  { value: "scalar-last", words: lettersOf["scalar-last"] },
] as const;

export const choiceWords: { [Choice in BehaviourAxis]: ChoiceWords<Values[Choice]> } = {
  constructor: { name: "Constructor takes", about: "the order of the constructor", values: orders },
  array: { name: "Stores and prints", about: "the order of the printed numbers", values: orders },
  handedness: {
    name: "Product",
    about: "the product",
    values: [
      { value: "right", words: `Hamilton, ${unbroken(productWords.right)}`, preset: "hamilton" },
      { value: "left", words: `Shuster, ${unbroken(productWords.left)}`, preset: "jpl" },
    ],
  },
  rotate: {
    name: "Rotates a column by",
    about: "how it rotates a vector",
    values: [
      { value: "R", words: "R(q)", preset: "hamilton" },
      { value: "C", words: "C(q)", preset: "jpl" },
    ],
  },
  matrix: {
    name: "Matrix of q",
    about: "what its matrix is",
    values: [
      { value: "R", words: "R(q)", preset: "hamilton" },
      { value: "C", words: "C(q)", preset: "jpl" },
    ],
  },
  attitude: {
    name: "Body yawed by +90°",
    about: "the sign of an attitude",
    values: [
      { value: "canonical", words: "z > 0" },
      { value: "conjugated", words: "z < 0, conjugate" },
    ],
  },
  perturbation: {
    name: "Small turn on the axes of",
    about: "the axes of a small turn",
    values: [
      { value: "local", words: "the body" },
      { value: "global", words: "the world" },
    ],
  },
};

/** First what the library does, then how its user means an attitude. */
export const choicesOfLibrary = [
  ...(["constructor", "array", "handedness", "rotate", "matrix"] as const),
] satisfies BehaviourAxis[];
export const choicesOfUse = ["attitude", "perturbation"] as const satisfies BehaviourAxis[];

/** The value of a choice that is left; nothing while both are, or none. */
export function settledValue(remaining: Remaining, choice: BehaviourAxis): string | undefined {
  const values: readonly string[] = remaining[choice];
  return values.length === 1 ? values[0] : undefined;
}

/** A value in words. */
export function wordsOfValue(choice: BehaviourAxis, value: string): ValueWords | undefined {
  const { values }: { values: readonly ValueWords[] } = choiceWords[choice];
  return values.find((words) => words.value === value);
}

/** `a`, `a and b`, `a, b and c`. */
export function listed(parts: readonly string[], word = "and"): string {
  const last = parts.at(-1) ?? "";
  return parts.length < 2 ? last : `${parts.slice(0, -1).join(", ")} ${word} ${last}`;
}

export const sideWords: Record<Side, string> = {
  left: "the left operand a",
  right: "the right operand b",
};

/** What product and rotation make together, once both are settled. */
export function settledFamily({ handedness, rotate }: Remaining): Family | undefined {
  if (handedness.length !== 1 || rotate.length !== 1) return undefined;
  if (handedness[0] === "right") return rotate[0] === "R" ? "hamilton" : "transposed-matrix";
  return rotate[0] === "C" ? "shuster" : "reversed-product";
}

/** What the family of a library means beside Hamilton and JPL. */
export const familySays: Record<Family, string> = {
  hamilton: "Product and rotation are those of Hamilton. The matrix of a * b is R(a) R(b).",
  shuster: "Product and rotation are those of JPL. The matrix of a * b is C(a) C(b).",
  "reversed-product":
    "JPL rotates by C(q); this library rotates by R(q), as Hamilton does. Its a * b is Hamilton's b * a, as row vectors want it: x C(a) C(b).",
  "transposed-matrix":
    "Hamilton rotates by R(q); this library rotates by C(q), as JPL does. The matrix of a * b is C(b) C(a).",
};

/** What to look at when two observations disagree about a choice. */
export const checks: Record<BehaviourAxis, string> = {
  constructor: "whether all four-number inputs went in through the same constructor",
  array: "whether both were printed by the same call: a formatted text may name or reorder them",
  handedness: "whether a stood left of b, and the sign of what was printed",
  rotate: "whether the vector was rotated forwards, not back, and x is what went in",
  matrix: "whether the nine numbers run row by row: choose column by column, or not sure",
  attitude: "which quaternion of the body it is: of body to world, or of world to body",
  perturbation: "on whose axes φ was meant",
};

/** What may be wrong with numbers that no behaviour prints. */
export const unexplainedAdvice = [
  "a typing error, in what went in or in what came out",
  "an input that is not of norm 1: some libraries normalise it and some scale by it",
  "very few decimals: print more of them",
  "operands in another order, or a call that does something else besides",
] as const;
