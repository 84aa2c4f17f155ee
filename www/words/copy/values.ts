// What copied values say they are; plain ASCII, since they go into source files.
import type { Direction } from "../../engine.ts";

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
  leftProduct: (letters: string) => `q p = L p, on ${letters}`,
  rightProduct: (letters: string) => `p q = R p, on ${letters}`,
};
