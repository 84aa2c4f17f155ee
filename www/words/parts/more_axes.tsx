// The words of *More*, with the five axes.
import type { ComponentChildren } from "preact";
import type { Direction } from "../../engine.ts";
import { arrowOf } from "../conventions.ts";

export const more = "More";
export const named = "Conventions with a name:";
export const five = "What four typed numbers mean is five choices, each by itself.";

/** What nine typed numbers are, by the direction of the matrix. */
export const matrix = (direction: Direction) => (
  <>
    Nine typed numbers are a matrix, row by row, with a function and a direction of its own:{" "}
    <strong>{arrowOf(direction)}</strong>, its columns are the{" "}
    {direction === "body-to-world" ? "body axes in the world" : "world axes in the body"}.
  </>
);

/** What the matrix is beside the four numbers as declared. */
export const beside = (formula: ComponentChildren) => (
  <> Of the four numbers as declared it is {formula}.</>
);

export const ofMatrix = "of the matrix";
