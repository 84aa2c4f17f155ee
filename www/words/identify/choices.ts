// What is observed of a library and what that settles: the probes, the eight choices, what to check.
import type { BehaviourAxis, Family, MatrixLayout, ProbeKind, Side } from "../../engine.ts";
import type { ChoiceValues } from "../../model/behaviour.ts";
import { lettersOf } from "../conventions.ts";
import { productWords } from "../library_behaviour.ts";
import { listed, unbroken } from "../phrases.ts";

/** What each probe is called and asks. */
export const probeWords: Record<ProbeKind, { name: string; asks: string }> = {
  product: {
    name: "a product",
    asks: "What is a * b? Of two units, the place tells the order and the sign tells the product.",
  },
  rotate: {
    name: "a rotated vector",
    asks: "Where does q take the vector v, by the call that rotates?",
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
    name: "a body turned by 90°",
    asks: "Turn the body by +90° about the world's z axis: which quaternion is its attitude?",
  },
  perturb: {
    name: "a small rotation added",
    asks: "What is q after its own call added the small rotation φ, in radians?",
  },
};

/** How nine numbers run. */
export const layoutNames: Record<MatrixLayout, string> = {
  "as-written": "as the lines show",
  rows: "row by row",
  columns: "column by column",
  unknown: "not sure",
};

/** The name of a choice, as what it is settled or disputed, and its values. */
export const choiceWords: {
  [Choice in BehaviourAxis]: {
    name: string;
    about: string;
    values: Record<ChoiceValues[Choice], string>;
  };
} = {
  constructor: {
    name: "Constructor takes",
    about: "the order of the constructor",
    values: lettersOf,
  },
  array: {
    name: "Stores and prints",
    about: "the order of the printed numbers",
    values: lettersOf,
  },
  handedness: {
    name: "Product",
    about: "the product",
    values: {
      right: `Hamilton, ${unbroken(productWords.right)}`,
      left: `Shuster, ${unbroken(productWords.left)}`,
    },
  },
  rotate: {
    name: "Rotates a column by",
    about: "how it rotates a vector",
    values: { R: "R(q)", C: "C(q)" },
  },
  matrix: {
    name: "Matrix of q",
    about: "what its matrix is",
    values: { R: "R(q)", C: "C(q)" },
  },
  attitude: {
    name: "Body yawed by +90°",
    about: "the sign of an attitude",
    values: { canonical: "z > 0", conjugated: "z < 0, conjugate" },
  },
  perturbation: {
    name: "Small rotation about the axes of",
    about: "the axes of a small rotation",
    values: { local: "the body", global: "the world" },
  },
  incrementSign: {
    name: "Small rotation φ turns the body by",
    about: "the sign of a small rotation",
    values: { physical: "φ, physical sign", formal: "−φ, formal sign" },
  },
};

/** How many behaviours there are: each choice has two values. */
export const allBehaviours = 2 ** Object.keys(choiceWords).length;

/** As what choices are settled or disputed. */
export const aboutOf = (choices: readonly BehaviourAxis[]) =>
  listed(choices.map((choice) => choiceWords[choice].about));

export const sideWords: Record<Side, string> = {
  left: "the left operand a",
  right: "the right operand b",
};

/** What the family of a library means beside Hamilton and JPL. */
export const familySays: Record<Family, string> = {
  hamilton: "Product and rotation are those of Hamilton. The matrix of a * b is R(a) R(b).",
  shuster: "Product and rotation are those of JPL. The matrix of a * b is C(a) C(b).",
  "reversed-product":
    "JPL rotates by C(q); this library rotates by R(q), as Hamilton does. Its a * b is Hamilton's b * a, as row vectors want it: v\u00a0C(a)\u00a0C(b).",
  "transposed-matrix":
    "Hamilton rotates by R(q); this library rotates by C(q), as JPL does. The matrix of a * b is C(b) C(a).",
};

/** What to look at when two observations disagree about a choice. */
export const checks: Record<BehaviourAxis, string> = {
  constructor: "whether all four-number inputs went in through the same constructor",
  array: "whether both were printed by the same call: a formatted text may name or reorder them",
  handedness: "whether a stood left of b, and the sign of what was printed",
  rotate: "whether the vector was rotated forwards, not back, and v is what went in",
  matrix: "whether the nine numbers run row by row: choose column by column, or not sure",
  attitude: "which quaternion of the body it is: of body to world, or of world to body",
  perturbation: "about whose axes φ was meant",
  incrementSign: "whether φ was added",
};

/** What to look at besides. */
export const checkSource = "that all come from one library";

/** What may be wrong with numbers that no behaviour prints. */
export const unexplainedAdvice = [
  "a typing error, in what went in or in what came out",
  "an input that is not of norm 1: some libraries normalise it and some scale by it",
  "very few decimals: print more of them",
  "operands in another order, or a call that does something else besides",
] as const;
