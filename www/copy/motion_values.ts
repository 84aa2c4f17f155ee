// The values of Motion as values that can be copied. What is no rotation is a vector or a matrix, so that no
// format makes a rotation of it.
import type {
  CovarianceReport,
  DerivativeReport,
  Describe,
  IncrementReport,
  PathReport,
  PointReport,
  RateAxes,
  SidedQuaternion,
} from "../engine.ts";
import { namesOf } from "../model/component_order.ts";
import type { Copied } from "../model/copied.ts";
import { sequenceName } from "../model/euler_sequence.ts";
import { motionCopies as words } from "../words/copy/motion_values.ts";
import { copiedWords } from "../words/copy/values.ts";
import { matrixValue, quaternionValue } from "./values.ts";

const vectorValue = (symbol: string, numbers: readonly number[], on: string): Copied => ({
  kind: "vector",
  symbol,
  numbers,
  on,
});

const lettersOf = ({ convention }: Pick<SidedQuaternion, "convention">) =>
  namesOf[convention.order].join(" ");

/** The attitude after a small turn. */
export const turnedValue = ({ quaternion, convention }: SidedQuaternion, describe: Describe) =>
  quaternionValue("q'", quaternion, convention, describe);

/** q̇, which is no rotation. */
export const derivativeValue = (row: SidedQuaternion) => {
  const { handedness, direction } = row.convention;
  const product = handedness === "right" ? "ij = k" : "ij = -k";
  const convention = `${product}, ${direction.replaceAll("-", " ")}`;
  return vectorValue("dq/dt", row.quaternion.array, words.derivative(convention, lettersOf(row)));
};

export const omegaValue = (row: SidedQuaternion) =>
  matrixValue("Omega", row.matrix, words.omega(lettersOf(row)));

/** The values of a small turn, of which this row is the one as declared. */
export function incrementValues(
  increment: IncrementReport,
  declared: SidedQuaternion,
  describe: Describe,
) {
  const { bodyRad, worldRad, smallAngleQuaternion, smallAngleMatrix, bodyToWorld } = increment;
  return {
    body: vectorValue("delta", bodyRad, words.increment("body")),
    world: vectorValue("delta", worldRad, words.increment("world")),
    error: quaternionValue("dq", declared.factor, declared.convention, describe),
    smallQuaternion: vectorValue(
      "[1, delta/2]",
      smallAngleQuaternion.array,
      words.smallQuaternion(lettersOf(declared)),
    ),
    smallMatrix: matrixValue("I + [delta]x", smallAngleMatrix, words.smallMatrix),
    matrix: matrixValue("R(q')", bodyToWorld, copiedWords.direction["body-to-world"]),
  };
}

/** The values of a rate; of angles the rates are in the unit in which they are shown. */
export function rateValues(derivative: DerivativeReport) {
  const { bodyRad, worldRad, euler, vectorRateRad, bodyToWorld } = derivative;
  const { rightJacobian, rightJacobianInverse } = derivative;
  return {
    body: vectorValue("omega", bodyRad, words.rate("body")),
    world: vectorValue("omega", worldRad, words.rate("world")),
    eulerRates: (rates: readonly number[], per: string) =>
      vectorValue("de/dt", rates, words.eulerRates(sequenceName(euler.sequence), per)),
    vectorRate: vectorRateRad && vectorValue("dv/dt", vectorRateRad, words.vectorRate),
    matrix: matrixValue("dR/dt", bodyToWorld, words.matrixRate),
    jacobian: matrixValue("J_r", rightJacobian, words.jacobian),
    inverse:
      rightJacobianInverse && matrixValue("J_r^-1", rightJacobianInverse, words.inverseJacobian),
  };
}

export function pathValues(
  { end, turn, ways }: PathReport,
  of: SidedQuaternion["convention"],
  describe: Describe,
) {
  const vector: Copied = { kind: "rotation-vector", vectorRad: turn.rotationVectorRad };
  return {
    end: quaternionValue("q", end, of, describe),
    turn: vector,
    path: matrixValue("path", ways[0] ?? [], words.path),
  };
}

export const covarianceValue = (report: CovarianceReport, axes: RateAxes) =>
  matrixValue("P", report[axes], words.covariance(axes));

export const pointValues = (point: PointReport, letters: string) => ({
  image: vectorValue("R x", point.world, words.image),
  byBodyTurn: matrixValue("-R [x]x", point.byBodyTurn, words.byTurn("body")),
  byWorldTurn: matrixValue("-[R x]x", point.byWorldTurn, words.byTurn("world")),
  byComponents: matrixValue("d(q x q*)/dq", point.byComponents, words.byComponents(letters)),
});
