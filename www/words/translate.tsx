// The words of the Translate view: the ends, the change of the numbers and why, what else changes.
import type { ComponentChildren } from "preact";
import type {
  Assumption,
  ComponentOrder,
  Direction,
  MappedAxes,
  MistakeKind,
  Side,
  TranslatedEnd,
  TranslateReport,
} from "../engine.ts";
import { lettersOf } from "./conventions.ts";
import { notEstablished, takesWords } from "./library_behaviour.ts";
import { unbroken } from "./phrases.ts";

/** What the two ends are called. */
export interface EndNames {
  from: string;
  to: string;
}

/** `R(q)` or `C(q)`. */
type Action = ComponentChildren;

export const translateWords = {
  input: "Input",
  swap: "Swap sides",
  examples: "Examples",
  exampleNames: {
    ceres: "A JPL filter log to Ceres",
    px4: "PX4 to ROS",
    matlab: "MATLAB Aerospace to SciPy",
    camera: "World to camera, to Eigen",
    directx: "DirectXMath to GLM",
    unity: "ROS to Unity",
  },
  readAs: "Read as",
  looksLike: (name: string) => `This looks like ${name}:`,
  translateFrom: (name: string) => `translate from ${name}`,
  components: (name: string, order: ComponentOrder) => `q of ${name} as ${lettersOf[order]}`,
  yours: "Your convention",
  /** Where both ends have the same name. */
  sameNames: (name: string): EndNames => ({ from: `${name} (from)`, to: `${name} (to)` }),
  /** What a screen reader hears when the result changes. */
  spoken: (name: string, numbers: readonly string[], report: TranslateReport) =>
    `Result for ${name}: ${numbers.join(", ")}. ${changeWords(report)}.`,
} as const;

/** `Reordered, not conjugated` and the like. */
export function changeWords({ change, axes }: TranslateReport): string {
  const words = {
    copied: "Neither reordered nor conjugated",
    reordered: "Reordered, not conjugated",
    conjugated: "Conjugated, not reordered",
    "reordered-and-conjugated": "Reordered and conjugated",
  }[change];
  return axes ? `${words}, and on other axes` : words;
}

export const endWords = {
  side: { from: "From", to: "To" },
  record: "its record",
  takes: (action: string) => `Its ${action}(q) takes`,
  /** How a direction is known. */
  documented: "documented",
  assumed: "assumed",
  customary: "customary",
  order: "Its numbers stand as",
  array: "its array",
  constructor: "its constructor",
  five: "The five axes",
} as const;

export const whyWords = {
  /** What the frames ask for, what becomes of the vector part, what becomes of the order. */
  sentence: ({
    isAssumed,
    frames,
    isConjugated,
    order,
    hasAxes,
  }: {
    isAssumed: boolean;
    frames: ComponentChildren;
    isConjugated: boolean;
    order: string;
    hasAxes: boolean;
  }) => (
    <>
      {isAssumed && <strong>As is assumed, for it is not established: </strong>}
      {frames}{" "}
      <strong>{isConjugated ? "The vector part changes its sign" : "Nothing is conjugated"}</strong>
      , {order}.{hasAxes && " The new axes then change the numbers once more."}
    </>
  ),
  /** The same action and the same direction. */
  same: (names: EndNames, direction: Direction, action: Action) => (
    <>
      {names.from} and {names.to} both take {takesWords[direction]} by {action}.
    </>
  ),
  each: (names: EndNames, directions: [Direction, Direction], actions: [Action, Action]) => (
    <>
      {names.from} takes {takesWords[directions[0]]} by {actions[0]}, {names.to} takes{" "}
      {takesWords[directions[1]]} by {actions[1]}.
    </>
  ),
  inverse: " One undoes the other, so each is the inverse of the other.",
  transposed: (names: EndNames, direction: Direction, actions: [Action, Action]) => (
    <>
      {names.from} and {names.to} both take {takesWords[direction]}, one by {actions[0]}, one by{" "}
      {actions[1]}, which for the same numbers are transposes: to be one and the same matrix they
      need conjugate numbers.
    </>
  ),
  asAsked: (r: Action, c: Action) => (
    <>
      {" "}
      For the same numbers {r} and {c} are transposes, which is just what the two directions ask
      for.
    </>
  ),
  /** What becomes of the order; a constructor may have another one than the array. */
  orderStays: (order: ComponentOrder, constructorOrder: ComponentOrder | undefined) =>
    `and the order of the array stays ${unbroken(lettersOf[order])}${
      constructorOrder === undefined || constructorOrder === order
        ? ""
        : ` (the constructor takes ${unbroken(lettersOf[constructorOrder])})`
    }`,
  scalarMoves: {
    "scalar-first": "and the scalar moves from the end to the front",
    "scalar-last": "and the scalar moves from the front to the end",
  } satisfies Record<ComponentOrder, string>,
} as const;

export const columnWords = {
  product: `product ${notEstablished}`,
  takes: (action: Action, direction: Direction) => (
    <>
      {action} takes {takesWords[direction]}.
    </>
  ),
  assumptions: {
    order: "Assumed: the order of its numbers is not established, and is taken as x y z w.",
    action: "Assumed: what it does to a vector is not established, and is taken as R(q).",
  } satisfies Record<Assumption, string>,
  code: "code",
  copiedLine: (name: string) => `the line of code of ${name}`,
  copiedCall: (name: string) => `the call of ${name}`,
  matrix: (name: string) => `matrix of ${name}`,
  asPrinted: "as printed, ",
  noMatrix: `What it prints as the matrix is ${notEstablished}.`,
  constructed: (name: string) => `q of ${name} as its constructor takes it`,
  constructedNote: "as its constructor takes them",
  first: {
    right: "acts on a vector first by b, then by a",
    left: "acts on a vector first by a, then by b",
  } satisfies Record<Side, string>,
  noFirst: `which of the two acts first is ${notEstablished}`,
  called: "is called",
  noFamily: `its product is ${notEstablished}`,
  nonUnit: "norm not 1",
  noNonUnit: `what it makes of it is ${notEstablished}`,
} as const;

export const productCardWords = {
  title: "A product",
  becomes: "becomes",
  neither: (
    <>
      The axes of the world and of the body change differently. So the product of two translated
      attitudes is <strong>neither of the two products</strong>: multiply first, then translate the
      result.
    </>
  ),
  unknown: (identifyAddress: string) => (
    <>
      The product of one of the two is {notEstablished}; a message has none of its own, only the
      library that reads it. With what a library prints, <a href={identifyAddress}>Identify</a>{" "}
      finds it out.
    </>
  ),
  /** Which operand acts first at either end, whether both lead the same way, and what follows. */
  operands: (
    from: TranslatedEnd,
    to: TranslatedEnd,
    names: EndNames,
    product: "same" | "reversed",
  ) => (
    <>
      {from.firstToAct === to.firstToAct
        ? `In both, the ${from.firstToAct} operand acts first on a vector`
        : `In ${names.from} the ${from.firstToAct} operand acts first, in ${names.to} the ${to.firstToAct} one`}
      {from.direction === to.direction
        ? `, and both lead ${wayWords[from.direction]}`
        : `; one leads ${wayWords[from.direction]}, the other back`}
      . So, with <var>a</var> and <var>b</var> translated,{" "}
      <strong>
        {product === "reversed" ? "the operands change places" : "the operands keep their places"}
      </strong>
      .
    </>
  ),
} as const;

const wayWords: Record<Direction, string> = {
  "body-to-world": "from body to world",
  "world-to-body": "from world to body",
};

export const mistakesWords = {
  title: "What goes wrong with these numbers",
  none: "no difference: these numbers do not show the mistake, others will",
  off: (angle: ComponentChildren) => <>{angle} off</>,
} as const;

const mistakeWords: Record<MistakeKind, string> = {
  copied: "copied as they are",
  "not-reordered": "not reordered",
  "not-conjugated": "not conjugated",
  "conjugated-needlessly": "conjugated, though it must not be",
  "constructor-order": "passed to the constructor as the array stands",
  "axes-kept": "axes not changed",
};

/** A mistake; where two things are to be done, one of them may be done and the other not. */
export function mistakeOf(kind: MistakeKind, change: TranslateReport["change"]): string {
  if (change === "reordered-and-conjugated") {
    if (kind === "not-reordered") return "conjugated, but not reordered";
    if (kind === "not-conjugated") return "reordered, but not conjugated";
  }
  return mistakeWords[kind];
}

/** A side of a change of axes. */
export const frameWords = { world: "world", body: "body" } as const;

export const axesCardWords = {
  title: "The change of axes",
  formula: (
    <>
      The new matrix is <var>A</var>
      <sub>{frameWords.world}</sub> <var>R</var> <var>A</var>
      <sub>{frameWords.body}</sub>
      <sup>T</sup>, with <var>R</var> from body to world.
    </>
  ),
  matrix: (of: keyof typeof frameWords) => `new axes of the ${frameWords[of]}`,
  caption: ({ text, determinant }: MappedAxes) =>
    `new x y z = ${text.replaceAll("-", "−")}, determinant ${determinant > 0 ? "+1" : "−1"}`,
  /** World and body change differently, and the hand is kept or changed. */
  different: (hand: MappedAxes["hand"]) =>
    `World and body change differently, so the turn that leads from the one to the other is another one than before${
      hand === "changed" ? ", counted by the other hand of both" : ""
    }. Determinants of different sign would make a reflection, which has no quaternion.`,
  mirrored: (
    <>
      <strong>Both change the hand of the axes</strong>: right-handed ones become left-handed, or
      the other way round. The turn in space stays the same, but it is counted by the other hand:
      what was counter-clockwise about an axis, seen against it, is now clockwise. So the rotation
      vector becomes −<var>A</var> times the old one, not <var>A</var> times. One side alone would
      be a reflection, which has no quaternion.
    </>
  ),
  kept: "Both keep the hand of the axes (determinant +1), so a turn that was counter-clockwise about an axis is so still.",
} as const;
