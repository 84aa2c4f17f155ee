// The words of the five choices.
import type { ComponentChildren } from "preact";
import type { Direction } from "../../engine.ts";
import { arrowOf } from "../conventions.ts";

export const named = "Named conventions:";
export const five = "What four numbers mean is five independent choices.";

/** What nine typed numbers are, by the direction of the matrix. */
export const matrix = (direction: Direction) => (
  <>
    Nine numbers are a matrix, row by row, with its own function and direction:{" "}
    <strong>{arrowOf(direction)}</strong>, its columns are the{" "}
    {direction === "body-to-world" ? "body axes in the world" : "world axes in the body"}.
  </>
);

/** What the matrix is beside the four numbers as declared. */
export const beside = (formula: ComponentChildren) => (
  <> For the four numbers as declared it is {formula}.</>
);

export const ofMatrix = "of the matrix";
