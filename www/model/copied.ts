// A value that can be copied as code: what it is and what it means, not how it is shown.
import type { Convention, Direction, EulerSequence, MatrixConvention } from "../engine.ts";

type Numbers = readonly number[];
export type Rows = readonly Numbers[];

export interface NamedNumbers {
  w: number;
  x: number;
  y: number;
  z: number;
}

export interface CopiedQuaternion {
  kind: "quaternion";
  /** What stands for it in a formula, in ASCII: `q`, `q*`, `p (.) q`. */
  symbol: string;
  components: NamedNumbers;
  /** Of the components, by the core; undefined where a double cannot hold it. */
  norm: number | undefined;
  /** What these four numbers mean. */
  convention: Convention;
  /** The matrix that it acts with on coordinates in its own convention. */
  matrix?: Rows;
}

export interface CopiedMatrix {
  kind: "matrix";
  symbol: string;
  rows: Rows;
  /** Which coordinates to which it takes, or what else it does; in ASCII. */
  does: string;
}

export interface CopiedVector {
  kind: "vector";
  symbol: string;
  numbers: Numbers;
  /** On which axes these are coordinates; in ASCII. */
  on: string;
}

export interface CopiedAxisAngle {
  kind: "axis-angle";
  axis: Numbers;
  angleRad: number;
}

export interface CopiedRotationVector {
  kind: "rotation-vector";
  vectorRad: Numbers;
}

export interface CopiedEuler {
  kind: "euler";
  sequence: EulerSequence;
  anglesRad: Numbers;
}

export type Copied =
  | CopiedQuaternion
  | CopiedMatrix
  | CopiedVector
  | CopiedAxisAngle
  | CopiedRotationVector
  | CopiedEuler;

export type Kind = Copied["kind"];

/** What the matrix of an end is: the one that the end prints of these numbers, or that of q/|q|. */
export type EndMatrix = "as-printed" | "of-unit";

const opposite: Record<Direction, Direction> = {
  "body-to-world": "world-to-body",
  "world-to-body": "body-to-world",
};

/** The convention in which the conjugate of a quaternion is the same attitude. */
export function reversed(convention: Convention): Convention {
  return { ...convention, direction: opposite[convention.direction] };
}

/** From which coordinates to which a quaternion takes a vector when it acts in its convention. */
export function directionOfAction({ function: does, direction }: MatrixConvention): Direction {
  return does === "passive" ? direction : opposite[direction];
}

/**
 * The direction of R(q), the matrix that a library with the product ij = k makes of the numbers.
 * Where the convention has ij = -k, it acts by C(q), the transpose.
 */
export function directionOfR(convention: Convention): Direction {
  const acts = directionOfAction(convention);
  return convention.handedness === "right" ? acts : opposite[acts];
}
