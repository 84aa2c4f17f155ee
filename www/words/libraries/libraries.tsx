// The words of the Libraries view.
import type { Known } from "../../engine.ts";
import { notEstablished } from "../library_behaviour.ts";

export const input = "Input";
export const title = "What libraries mean by four numbers";
export const find = "Find a library";
export const findExample = "name, module, file, language, xyzw, JPL, left-handed …";

export const matrices = (
  <>
    <strong>R</strong> is the matrix of Hamilton's active rotation, <var>R</var>(<var>q</var>){" "}
    <var>v</var> = <var>q</var> <var>v</var> <var>q</var>*, and <strong>C</strong> its transpose.
  </>
);

export const actsFirst =
  "Where no call of a library rotates a vector, what acts first follows from its matrix.";

/** Where a library is one line. */
export const constructorInBold = (
  <>
    In <strong>bold</strong> the order of the constructor, where it is not that of the array.
  </>
);

export const dash = `A dash means ${notEstablished}.`;

export const groups = "Groups";

export const none = "No record has all these words. Try one of them, or";
export const showAll = (count: number) => `show all ${count}`;

/** How many records are shown, and how each is known. */
export const counted = (
  shown: number,
  all: number,
  known: readonly (readonly [Known, number])[],
) => {
  const total = shown === all ? `${all} records` : `${shown} of ${all}`;
  const parts = known.map(([how, count]) => `${count} ${countWords[how]}`);
  return parts.length === 0 ? `${total}.` : `${total}: ${parts.join(", ")}.`;
};

/** The heads of the columns, in the order of the cells. */
export const columns = {
  library: "Library",
  version: "Version",
  known: "Known",
  array: "Array",
  constructor: "Constructor",
  product: "Product",
  rotates: "Rotates by",
  matrix: "Matrix as printed",
  first: "a * b: first",
  short: "In short",
};

/** What a screen reader hears when the table changes. */
export const spoken = (shown: number, all: number, opened: string | undefined) =>
  `${shown} of ${all} libraries.${opened === undefined ? "" : ` The record of ${opened} is open.`}`;

/** What is said after a number of records. */
const countWords: Record<Known, string> = {
  run: "run",
  read: "known from the source",
  documented: "only from the documentation",
};
