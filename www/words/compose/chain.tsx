// The words of a product of many factors, and of the forms of one of two.
import type { Preset } from "../../model/page_state.ts";

export const title = "More than two";
export const factor = (place: number) => `factor ${place}`;
export const inverse = "inverted";
export const inverts = (place: number) => `factor ${place} inverted`;
export const reverse = "multiplied in reverse";
export const removes = (place: number) => `Remove factor ${place}`;
export const remove = "Remove";
export const add = "Add a factor";

export const product = "product";
export const productIn = (convention: string) => `the product, ${convention}`;
export const itsInverse = "its inverse";
export const inverseIn = (convention: string) => `the inverse of the product, ${convention}`;
export const matrixIn = (letter: string) => `${letter} of the product of all factors`;
export const rotationVector = "rotation vector";
export const turn = (angle: string, axis: string) => `rad · ${angle} about ${axis}`;
export const euler = (sequence: string) => `Euler angles ${sequence}`;
export const mean = "the mean of the factors, as declared";
export const noMean = "The factors have no mean: several rotations are as near to all of them.";

const signs: Record<Preset, string> = { hamilton: "⊙", jpl: "⊗" };
type Factors = readonly [string, string];
export const forms = ([left, right]: Factors) => `${left} ⊙ ${right} in other forms`;
/** Of a product, the inverse is that of the inverses in reverse. */
export const inverseOf = ([left, right]: Factors, preset: Preset) =>
  `(${left} ${signs[preset]} ${right})⁻¹ = ${right}⁻¹ ${signs[preset]} ${left}⁻¹`;
