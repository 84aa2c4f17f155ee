// What a text is said to have been read as, before the four numbers that follow from it.
import type { ComponentChildren } from "preact";
import type { EulerFrame } from "../../engine.ts";

export const axisAngle = (angle: ComponentChildren, axis: ComponentChildren) => (
  <>
    {angle} about {axis}:{" "}
  </>
);

export const rotationVector = (vector: ComponentChildren) => <>a rotation vector {vector} rad: </>;

export const halfAngleVector = (vector: ComponentChildren) => (
  <>a half-angle vector, angle/2 times the axis, {vector} rad: </>
);

export const gibbsVector = (vector: ComponentChildren) => (
  <>a Gibbs vector, tan(angle/2) times the axis, {vector}: </>
);

export const modifiedRodrigues = (parameters: ComponentChildren) => (
  <>modified Rodrigues parameters, tan(angle/4) times the axis, {parameters}: </>
);

export const euler = (sequence: string, frame: EulerFrame, angles: ComponentChildren) => (
  <>
    Euler angles {sequence}, about the {frame === "intrinsic" ? "moving" : "fixed"} axes, {angles}:{" "}
  </>
);

export const matrix = (direction: string) => `a matrix, ${direction}: `;
