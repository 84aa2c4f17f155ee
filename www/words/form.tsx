// What a text is said to have been read as, before the four numbers that follow from it.
import type { ComponentChildren } from "preact";
import type { EulerFrame } from "../engine.ts";

export const formWords = {
  axisAngle: (angle: ComponentChildren, axis: ComponentChildren) => (
    <>
      {angle} about {axis}:{" "}
    </>
  ),
  rotationVector: (vector: ComponentChildren) => <>a rotation vector {vector} rad: </>,
  euler: (sequence: string, frame: EulerFrame, angles: ComponentChildren) => (
    <>
      Euler angles {sequence}, about the {frame === "intrinsic" ? "moving" : "fixed"} axes, {angles}
      :{" "}
    </>
  ),
  matrix: (direction: string) => `a matrix, ${direction}: `,
} as const;
