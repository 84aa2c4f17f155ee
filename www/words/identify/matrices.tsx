// The words of a library of matrices.
import type { Direction, IncrementSign, MatrixConvention, Perturbation } from "../../engine.ts";

export const title = "A library of matrices";
export const lead =
  "Let it print these matrices, row by row as they multiply a column. What you cannot print stays empty.";
export const examples = "Examples";
export const exampleNames = {
  coordinates: "Its labels change coordinates",
  vectors: "Its labels move vectors",
  empty: "Empty fields",
};

export const steps = [
  "A body that was turned by +90° about the vertical z axis of the world.",
  "Three frames A, B and C: B is turned against A and C against B, about different axes. The matrices with these labels.",
  "A small turn φ in radians, best about x, which its own call adds to the first matrix.",
];
export const fields = {
  yawed: "the body turned by 90°",
  a: "A to B",
  b: "B to C",
  product: "A to C",
  rotationVector: "φ",
  printed: "the matrix after φ",
};

export const answer = "What its matrices mean";
/** Of 16. */
export const possible = (count: number) =>
  count === 1 ? "One of 16 conventions prints this." : `${count} of 16 conventions print this.`;
export const rowNames = {
  operator: "Times a column",
  labels: "Its labels",
  direction: "A body’s matrix is labelled",
  axes: "A small turn φ",
  sign: "It turns the body by",
};
export const operators: Record<Direction, string> = {
  "body-to-world": "body → world: coordinates of the body become those of the world",
  "world-to-body": "world → body: coordinates of the world become those of the body",
};
export const functions: Record<MatrixConvention["function"], string> = {
  passive: "change coordinates (passive): A to C is “B to C” times “A to B”",
  active: "move vectors (active): A to C is “A to B” times “B to C”",
};
export const directions: Record<Direction, string> = {
  "body-to-world": "body to world",
  "world-to-body": "world to body",
};
export const axes: Record<Perturbation, string> = {
  local: "is about the axes of the body",
  global: "is about the axes of the world",
};
export const signs: Record<IncrementSign, string> = { physical: "φ", formal: "−φ" };
/** What tells it. */
export const open = {
  operator: "open: the body turned by 90° tells",
  labels: "open: three frames about different axes tell",
  direction: "open: both above tell",
  axes: "open: a small turn of the body turned by 90° tells",
  sign: "open: the same tells",
};
export const read = "Read its matrices so";
