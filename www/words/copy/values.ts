// What copied values say they are; plain ASCII, since they go into source files.
import type { Direction, Frame, PrintedMatrix } from "../../engine.ts";
import type { EndMatrix } from "../../model/copied.ts";

export const copiedWords = {
  direction: {
    "body-to-world": "body to world, multiplies columns",
    "world-to-body": "world to body, multiplies columns",
  } satisfies Record<Direction, string>,
  /** The coordinates that a matrix of this direction gives. */
  coordinates: {
    "body-to-world": "coordinates in the world frame",
    "world-to-body": "coordinates in the body frame",
  } satisfies Record<Direction, string>,
  frames: (start: Frame, end: Frame) => `${frames[start]} to ${frames[end]}, multiplies columns`,
  leftProduct: (letters: string) => `q p = L p, on ${letters}`,
  rightProduct: (letters: string) => `p q = R p, on ${letters}`,
  endMatrix: {
    "as-printed": (name: string, { vectors }: PrintedMatrix) =>
      `as ${name} prints it; it ${multiplies[vectors]}`,
    "of-unit": (name: string, { form, vectors }: PrintedMatrix) =>
      `${form}(q/|q|) of the numbers of ${name}; it ${multiplies[vectors]}`,
  } satisfies Record<EndMatrix, unknown>,
  newAxes: (of: string, text: string) => `new axes of the ${of}: new x y z = ${text}`,
};

const multiplies: Record<PrintedMatrix["vectors"], string> = {
  column: "multiplies columns, M v",
  row: "multiplies rows, v M",
};

const frames: Record<Frame, string> = {
  world: "world",
  body: "body",
  "second-body": "second body",
};
