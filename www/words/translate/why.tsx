// Why numbers are conjugated or not, and reordered or not.
import type { ComponentChildren } from "preact";
import type { ComponentOrder, Direction, RecordNumbersKind } from "../../engine.ts";
import { lettersOf } from "../conventions.ts";
import { takesWords } from "../library_behaviour.ts";
import { unbroken } from "../phrases.ts";
import type { EndNames } from "./translate.ts";

/** `R(q)` or `C(q)`. */
type Action = ComponentChildren;

/** What the frames ask for, what becomes of the vector part, what becomes of the order. */
export const sentence = ({
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
    {isAssumed && <strong>Assumed, as it is not established: </strong>}
    {frames}{" "}
    <strong>{isConjugated ? "The vector part changes its sign" : "Nothing is conjugated"}</strong>,{" "}
    {order}.{hasAxes && " The new axes then change the numbers again."}
  </>
);

/** The same action and the same direction. */
export const same = (names: EndNames, direction: Direction, action: Action) => (
  <>
    {names.from} and {names.to} both take {takesWords[direction]} by {action}.
  </>
);

export const each = (
  names: EndNames,
  directions: [Direction, Direction],
  actions: [Action, Action],
) => (
  <>
    {names.from} takes {takesWords[directions[0]]} by {actions[0]}, {names.to} takes{" "}
    {takesWords[directions[1]]} by {actions[1]}.
  </>
);

/** What an end says by what it writes. */
export const by = (name: string, does: ComponentChildren, direction: Direction) => (
  <>
    {name} takes {takesWords[direction]} by {does}.
  </>
);

export const byIts: Record<RecordNumbersKind, string> = {
  "euler-angles": "its angles",
  "rotation-vector": "the turn of its vector, an axis times an angle",
  "axis-angle": "the turn of its axis and angle",
  matrix: "its matrix",
};

export const inverse = " Each is the inverse of the other.";

export const transposed = (names: EndNames, direction: Direction, actions: [Action, Action]) => (
  <>
    {names.from} and {names.to} both take {takesWords[direction]}, one by {actions[0]}, one by{" "}
    {actions[1]}, which for the same numbers are transposes: to be one and the same matrix they need
    conjugate numbers.
  </>
);

export const asAsked = (r: Action, c: Action) => (
  <>
    {" "}
    For the same numbers {r} and {c} are transposes, which is just what the two directions ask for.
  </>
);

/** What becomes of the order; a constructor may have another one than the array. */
export const orderStays = (order: ComponentOrder, constructorOrder: ComponentOrder | undefined) =>
  `and the order of the array stays ${unbroken(lettersOf[order])}${
    constructorOrder === undefined || constructorOrder === order
      ? ""
      : ` (the constructor takes ${unbroken(lettersOf[constructorOrder])})`
  }`;

export const scalarMoves = {
  "scalar-first": "and the scalar moves from the end to the front",
  "scalar-last": "and the scalar moves from the front to the end",
} satisfies Record<ComponentOrder, string>;
