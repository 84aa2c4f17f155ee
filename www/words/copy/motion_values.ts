// What the copied values of Motion say they are; plain ASCII, since they go into source files.
import type { RateAxes } from "../../engine.ts";

const on = { body: "on the body axes", world: "on the world axes" } satisfies Record<
  RateAxes,
  string
>;

export const motionCopies = {
  derivative: (convention: string, letters: string) =>
    `per second, of the quaternion ${letters}, ${convention}; no rotation`,
  omega: (letters: string) => `dq/dt = Omega q / 2, on ${letters}`,
  matrixRate: "per second, of the matrix body to world",
  increment: (axes: RateAxes) => `small turn in rad ${on[axes]}`,
  rate: (axes: RateAxes) => `angular velocity in rad/s ${on[axes]}`,
  eulerRates: (sequence: string, per: string) => `rates of the angles ${sequence}, in ${per}`,
  vectorRate: "rate of the rotation vector, in rad/s",
  smallQuaternion: (letters: string) =>
    `${letters}, the error quaternion but for terms of second order; its norm is not 1`,
  smallMatrix: "the matrix of the small turn but for terms of second order; no rotation",
  jacobian: "omega in the body = J_r dv/dt, of the rotation vector v",
  inverseJacobian: "dv/dt = J_r^-1 omega in the body, of the rotation vector v",
  path: "a row a moment: t in s, then w x y z of the Hamilton quaternion, body to world",
  covariance: (axes: RateAxes) => `covariance ${on[axes]}`,
  image: "coordinates in the world frame",
  byTurn: (axes: RateAxes) => `change of R x, body to world, with a small turn in rad ${on[axes]}`,
  byComponents: (letters: string) => `change of q x q* with ${letters}, a column each`,
} as const;
