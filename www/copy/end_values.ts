// The values of the ends of a translation as values that can be copied.
import type { Describe, TranslatedEnd } from "../engine.ts";
import { otherOrder } from "../model/component_order.ts";
import type { CopiedQuaternion, EndMatrix, Rows } from "../model/copied.ts";
import { endWords as words } from "../words/copy/end_values.ts";
import { matrixValue, quaternionValue } from "./values.ts";

export function endQuaternion(
  { components, convention }: TranslatedEnd,
  describe: Describe,
): CopiedQuaternion {
  return quaternionValue("q", components, convention, describe);
}

/** The values of an end of a translation. */
export function endValues(
  name: string,
  { components, convention, matrix }: TranslatedEnd,
  of: EndMatrix,
  describe: Describe,
) {
  const reordered = { ...convention, order: otherOrder[convention.order] };
  return {
    reordered: quaternionValue("q", components, reordered, describe),
    matrix: matrix && matrixValue("M", matrix.rows, words.endMatrix[of](name, matrix)),
  };
}

export const newAxesValue = (of: string, rows: Rows, text: string) =>
  matrixValue("A", rows, words.newAxes(of, text));
