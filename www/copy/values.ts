// The values of the reports as values that can be copied.
import type {
  Column,
  Components,
  Convention,
  Handedness,
  Product,
  ReadReport,
  TranslatedEnd,
} from "../engine.ts";
import type { EndMatrix } from "../model/copied.ts";
import {
  type Copied,
  type CopiedQuaternion,
  directionOfAction,
  type Rows,
  reversed,
} from "../model/copied.ts";
import { copiedWords as words } from "../words/copy/values.ts";

const letterOf: Record<Handedness, string> = { right: "R", left: "C" };
const signOf: Record<Handedness, string> = { right: "(.)", left: "(x)" };
const orderOf = ({ order }: Convention) => (order === "scalar-first" ? "w x y z" : "x y z w");

export function quaternionValue(
  symbol: string,
  { w, x, y, z, norm }: Components,
  convention: Convention,
  matrix?: Rows,
): CopiedQuaternion {
  return {
    kind: "quaternion",
    symbol,
    components: { w, x, y, z },
    norm,
    convention,
    ...(matrix && { matrix }),
  };
}

const matrixValue = (symbol: string, rows: Rows, does: string): Copied => ({
  kind: "matrix",
  symbol,
  rows,
  does,
});

/** The values of a column of Read. */
export function columnValues(column: Column) {
  const { convention, matrix, inverseMatrix } = column;
  const letter = letterOf[convention.handedness];
  const acts = directionOfAction(convention);
  const back = directionOfAction(reversed(convention));
  return {
    quaternion: quaternionValue("q", column.quaternion, convention, matrix),
    unit: quaternionValue("q/|q|", column.unit, convention, matrix),
    conjugate: quaternionValue("q*", column.conjugate, reversed(convention), inverseMatrix),
    inverse:
      column.inverse &&
      quaternionValue("q^-1", column.inverse, reversed(convention), inverseMatrix),
    matrix: matrixValue(`${letter}(q)`, matrix, words.direction[acts]),
    inverseMatrix: matrixValue(`${letter}(q)^T`, inverseMatrix, words.direction[back]),
    image: imageValue(`${letter}(q) x`, column.image, convention),
    left: matrixValue("L", column.leftProductMatrix, words.leftProduct(orderOf(convention))),
    right: matrixValue("R", column.rightProductMatrix, words.rightProduct(orderOf(convention))),
  };
}

function imageValue(
  symbol: string,
  numbers: readonly number[] | undefined,
  convention: Convention,
): Copied | undefined {
  const on = words.coordinates[directionOfAction(convention)];
  return numbers && { kind: "vector", symbol, numbers, on };
}

/** The values of the card of a convention that is neither preset. */
export function declaredValues({ declared, paired }: Pick<ReadReport, "declared" | "paired">) {
  const { convention, quaternion, matrix, image } = declared;
  const symbol = `${letterOf[convention.handedness]}(q)`;
  return {
    quaternion: quaternionValue("q", quaternion, convention, matrix),
    matrix: matrixValue(symbol, matrix, words.direction[directionOfAction(convention)]),
    image: imageValue(`${symbol} x`, image, convention),
    paired: matrixValue(
      `${paired.form}(q)`,
      paired.rows,
      words.direction[directionOfAction(paired.convention)],
    ),
  };
}

/** The values of a product. */
export function productValues({ convention, left, right, quaternion, matrix, frames }: Product) {
  const symbol = `${left} ${signOf[convention.handedness]} ${right}`;
  const does = words.frames(frames[0], frames[2]);
  return {
    quaternion: quaternionValue(symbol, quaternion, convention, matrix),
    matrix: matrixValue(`${letterOf[convention.handedness]}(${symbol})`, matrix, does),
  };
}

/** The values that no convention changes. */
export function turnValues({ turn, hamilton }: ReadReport) {
  const { axis, angleRad, rotationVectorRad } = turn;
  const { w, x, y, z } = hamilton.quaternion;
  const opposite = { w: 0 - w, x: 0 - x, y: 0 - y, z: 0 - z };
  return {
    axisAngle: axis && ({ kind: "axis-angle", axis, angleRad } satisfies Copied),
    rotationVector: {
      kind: "rotation-vector",
      vectorRad: rotationVectorRad,
    } satisfies Copied,
    opposite: {
      ...quaternionValue("-q", hamilton.quaternion, hamilton.convention, hamilton.matrix),
      components: opposite,
    },
  };
}

export function eulerValue({ sequence, anglesRad }: ReadReport["euler"]): Copied {
  return { kind: "euler", sequence, anglesRad };
}

export function endQuaternion({ components, convention }: TranslatedEnd): CopiedQuaternion {
  return quaternionValue("q", components, convention);
}

/** The values of an end of a translation. */
export function endValues(
  name: string,
  { components, convention, matrix }: TranslatedEnd,
  of: EndMatrix,
) {
  const other = convention.order === "scalar-first" ? "scalar-last" : "scalar-first";
  return {
    reordered: quaternionValue("q", components, { ...convention, order: other }),
    matrix: matrix && matrixValue("M", matrix.rows, words.endMatrix[of](name, matrix)),
  };
}

export const newAxesValue = (of: string, rows: Rows, text: string) =>
  matrixValue("A", rows, words.newAxes(of, text));
