// The values of the reports as values that can be copied.
import type {
  Column,
  Components,
  Convention,
  Describe,
  Direction,
  Handedness,
  ReadReport,
} from "../engine.ts";
import { namesOf } from "../model/component_order.ts";
import { operatorOf } from "../model/conventions.ts";
import type { Copied, CopiedQuaternion, Rows } from "../model/copied.ts";
import { copiedWords as words } from "../words/copy/values.ts";

export const letterOf: Record<Handedness, string> = { right: "R", left: "C" };

export function quaternionValue(
  symbol: string,
  { w, x, y, z, norm }: Components,
  convention: Convention,
  describe: Describe,
  matrix?: Rows,
): CopiedQuaternion {
  const { hamiltonMatrix, rules } = describe(convention);
  return {
    kind: "quaternion",
    symbol,
    components: { w, x, y, z },
    norm,
    convention,
    operator: rules.operator,
    hamiltonMatrix,
    ...(matrix && { matrix }),
  };
}

export const matrixValue = (symbol: string, rows: Rows, does: string): Copied => ({
  kind: "matrix",
  symbol,
  rows,
  does,
});

/** The values of a column of Read. */
export function columnValues(column: Column, describe: Describe) {
  const { convention, matrix, inverseMatrix, rules } = column;
  const letter = letterOf[convention.handedness];
  const { reversed } = describe(convention);
  const back = describe(reversed).rules.operator;
  const order = namesOf[convention.order].join(" ");
  const value = (symbol: string, components: Components) =>
    quaternionValue(symbol, components, convention, describe, matrix);
  const reversedValue = (symbol: string, components: Components) =>
    quaternionValue(symbol, components, reversed, describe, inverseMatrix);
  return {
    quaternion: value("q", column.quaternion),
    unit: value("q/|q|", column.unit),
    conjugate: reversedValue("q*", column.conjugate),
    inverse: column.inverse && reversedValue("q^-1", column.inverse),
    matrix: matrixValue(`${letter}(q)`, matrix, words.direction[rules.operator]),
    inverseMatrix: matrixValue(`${letter}(q)^T`, inverseMatrix, words.direction[back]),
    image: imageValue(`${letter}(q) v`, column.image, rules.operator),
    left: matrixValue("L", column.leftProductMatrix, words.leftProduct(order)),
    right: matrixValue("R", column.rightProductMatrix, words.rightProduct(order)),
  };
}

function imageValue(
  symbol: string,
  numbers: readonly number[] | undefined,
  operator: Direction,
): Copied | undefined {
  return numbers && { kind: "vector", symbol, numbers, on: words.coordinates[operator] };
}

/** The values of the card of a convention that is neither preset. */
export function declaredValues(
  { declared, paired }: Pick<ReadReport, "declared" | "paired">,
  describe: Describe,
) {
  const { convention, quaternion, matrix, image, rules } = declared;
  const symbol = `${letterOf[convention.handedness]}(q)`;
  return {
    quaternion: quaternionValue("q", quaternion, convention, describe, matrix),
    matrix: matrixValue(symbol, matrix, words.direction[rules.operator]),
    image: imageValue(`${symbol} v`, image, rules.operator),
    paired: matrixValue(
      `${paired.form}(q)`,
      paired.rows,
      words.direction[operatorOf(paired.convention)],
    ),
  };
}

/** The values that no convention changes. */
export function turnValues({ turn, hamilton }: ReadReport, describe: Describe) {
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
      ...quaternionValue("-q", hamilton.quaternion, hamilton.convention, describe, hamilton.matrix),
      components: opposite,
    },
  };
}

export function eulerValue({ sequence, anglesRad }: ReadReport["euler"]): Copied {
  return { kind: "euler", sequence, anglesRad };
}
