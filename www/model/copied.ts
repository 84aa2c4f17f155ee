// A value that can be copied as code: what it is and what it means, not how it is shown.
import type { Convention, Direction, EulerSequence } from "../engine.ts";
import type { ComponentName } from "./component_order.ts";

type Numbers = readonly number[];
export type Rows = readonly Numbers[];

export interface CopiedQuaternion {
  kind: "quaternion";
  /** What stands for it in a formula, in ASCII: `q`, `q*`, `p (.) q`. */
  symbol: string;
  components: Record<ComponentName, number>;
  /** Of the components, by the core; undefined where a double cannot hold it. */
  norm: number | undefined;
  /** What these four numbers mean. */
  convention: Convention;
  /** From which coordinates to which it takes a vector when it acts in its convention. */
  operator: Direction;
  /** The direction of R(q), the matrix that a library with the product ij = k makes of the numbers. */
  hamiltonMatrix: Direction;
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
