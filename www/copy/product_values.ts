// The values of a product of two as values that can be copied.
import type { Describe, Handedness, Product } from "../engine.ts";
import { framesWords } from "../words/copy/product_values.ts";
import { letterOf, matrixValue, quaternionValue } from "./values.ts";

const signOf: Record<Handedness, string> = { right: "(.)", left: "(x)" };

/** The values of a product. */
export function productValues(
  { convention, left, right, quaternion, matrix, frames }: Product,
  describe: Describe,
) {
  const symbol = `${left} ${signOf[convention.handedness]} ${right}`;
  const does = framesWords(frames[0], frames[2]);
  return {
    quaternion: quaternionValue(symbol, quaternion, convention, describe, matrix),
    matrix: matrixValue(`${letterOf[convention.handedness]}(${symbol})`, matrix, does),
  };
}
