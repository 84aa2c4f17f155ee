// The words of a declared convention that is neither preset.
import type { MatrixConvention } from "../../engine.ts";
import { arrowOf } from "../conventions.ts";

export const yours = "Your convention";
export const named = (symbol: string) => `${symbol} as declared`;
export const matrix = "matrix of q as declared";
export const coordinates = {
  passive: (arrow: string) => `the coordinates of v, ${arrow}`,
  active: (arrow: string) => `v turned, on the same axes; by the matrix that passively is ${arrow}`,
};
export const matrixDoes = {
  passive: (arrow: string) => arrow,
  active: (arrow: string) => `turns v; passively it is ${arrow}`,
};
export const pairedMatrix = "matrix as chosen beside q";
/** The function and the direction that were chosen for matrices. */
export const paired = ({ function: does, direction }: MatrixConvention) =>
  `chosen beside q: ${does}, ${arrowOf(direction)}`;
