// The words of what Motion tells of vectors.
import type { Perturbation, RateAxes } from "../../engine.ts";

export const covariance = "covariance";
export const covarianceLead: Record<Perturbation, string> = {
  local:
    "Of a vector or of small turns on the axes of the body: nine numbers, or three variances. R P Rᵀ has it on the axes of the world; R P alone is not symmetric.",
  global:
    "Of a vector or of small turns on the axes of the world: nine numbers, or three variances. Rᵀ P R has it on the axes of the body; Rᵀ P alone is not symmetric.",
};
export const covarianceOn: Record<RateAxes, string> = {
  body: "P on the body's axes",
  world: "P on the world's axes",
};
export const point = "point of the body";
export const image = "R x, in the world";
export const byBodyTurn = "by a small turn on the body's axes";
export const byWorldTurn = "by a small turn on the world's axes";
export const byComponents = (arrow: string, letters: string) =>
  `as declared, ${arrow}, of coordinates x before it; a column for each of ${letters}`;
