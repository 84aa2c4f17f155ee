// The words of the Motion view.
import type { IncrementSign, RateAxes } from "../../engine.ts";

export const input = "Input";
export const fields = {
  rate: "angular velocity at the beginning",
  rateEnd: "angular velocity at the end; empty where it stays",
  duration: "duration",
  increment: "small turn",
};
export const to = "to";
export const within = "in";
export const axesName = "Rate on the axes of";
export const axesWords: Record<RateAxes, string> = { body: "the body", world: "the world" };
export const signName = "δ is";
export const signWords: Record<IncrementSign, string> = {
  physical: "the turn",
  formal: "what Exp takes",
};
export const stepsName = "Steps";
export const units = (axes: string) =>
  `Rates in rad/s, deg/s or rpm; without a unit in rad/s. The small turn δ in rad or deg on the axes of ${axes} (under Convention: Perturbation); without a unit in rad.`;

export const names = {
  increment: "A small turn",
  derivative: "The derivative",
  path: "Over time",
};
export const empty = {
  increment: "Type a small turn δ.",
  derivative: "Type an angular velocity ω.",
  path: "Type an angular velocity and a duration.",
};
export const covarianceFold = "A covariance on the other axes";
export const pointFold = "How the image of a point changes with the attitude";
export const declared = "Declared";
export const more = "More";
export const onBody = "on the body's axes";
export const onWorld = "on the world's axes";
export const errorQuaternion = "error quaternion";
export const after = (symbol: string) => `${symbol} after the small turn`;
export const before = (symbol: string) => `${symbol} before it`;
export const otherAxes: Record<RateAxes, string> = {
  body: "The same numbers on the body's axes",
  world: "The same numbers on the world's axes",
};
export const taken = "Taken away instead of added";
export const matrixAfter = "matrix after the small turn";
export const smallAngle = "small angle";
export const smallMatrix = "small-angle matrix";
export const offBy = (quaternion: string, matrix: string, angle: string) =>
  `Off by ${quaternion} (quaternion) and ${matrix} (matrix); as a turn by ${angle}.`;
export const derivativeOf = (name: string) => `derivative of the ${name} quaternion`;
export const omega = (name: string) => `Ω of ${name}, q̇ = ½ Ω q`;
export const matrixRate = "derivative of the matrix body to world";
export const eulerRates = (sequence: string) => `rates of the angles ${sequence}, per second`;
export const eulerName = "Euler rates";
export const locked = "infinite: gimbal lock";
export const determinant = (value: string) => `determinant ${value} of what makes ω of them`;
export const vectorName = "Rotation vector rate, rad/s";
export const vectorRate = "rate of the rotation vector, per second";
export const wholeTurn = "undetermined: a whole turn";
export const rightJacobian = "right Jacobian";
export const inverseJacobian = "inverse of the right Jacobian";
export const endOf = "quaternion at the end";
export const wayName = "the way";
export const moments = (count: number) => `${count} moments: t, w, x, y, z`;
export const endTurn = "rotation vector, rad";

export const wrongName = "What goes wrong";
export const doesNotShow = "does not show here";
export const off = (angle: string) => `${angle} off`;
export const drawnName = "Drawn dashed";
export const rightOnly = "nothing";

export const stepsWrong = "Steps compared";
export const kinds = [
  "rate at the beginning",
  "rate in the middle",
  "two rates (Magnus)",
  "q + h q̇, normalised",
  "Runge–Kutta, components",
  "Runge–Kutta, angles",
  "Runge–Kutta, vector",
];
export const heads = (steps: number) => [
  "Step",
  `Error in rad, ${steps} steps`,
  "Order",
  "Norm off",
];
export const exact = "exact";
export const plotName =
  "Error in radians against the step in seconds, both on scales of powers of ten";
export const plotStep = "step, s";
export const plotError = "error, rad";
export const spoken = (angle: string) => `Result: at the end a rotation by ${angle}.`;
export const spokenStill = "Result: changed.";
