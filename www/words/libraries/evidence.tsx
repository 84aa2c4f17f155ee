// The words about the numbers that a library printed.
import type { ComponentChildren } from "preact";

export const title = "What it printed";
export const loading = "Loading the recorded numbers …";
export const none = "No numbers are recorded.";
export const failed = "The recorded numbers could not be loaded: reload the page.";

export const inputs = (a: ComponentChildren, b: ComponentChildren, v: ComponentChildren) => (
  <>
    Quaternions by name as w x y z, whatever the order of the library, but for the array. In:{" "}
    <var>a</var> = {a}, <var>b</var> = {b}, <var>v</var> = {v}.
  </>
);

/** What each recorded observation is called, in the order in which they are shown. */
export const observedNames: Record<string, string> = {
  arrayOfA: "a as an array",
  constructed1234: "0.1, 0.2, 0.3, 0.4 into the constructor, as w x y z",
  productAB: "a * b",
  productIJ: "i * j",
  matrixA: "matrix of a",
  matrixB: "matrix of b",
  matrixAB: "matrix of a * b",
  matrix2A: "matrix of 2 a",
  matrix0: "matrix of 0",
  rotateAV: "v rotated by a",
  rotate2AV: "v rotated by 2 a",
  rotate0V: "v rotated by 0",
  rotateABV: "v rotated by a * b",
  rotateBThenA: "v rotated by b, then by a",
  rotateAThenB: "v rotated by a, then by b",
  norm2A: "norm of 2 a",
  constructed0: "0, 0, 0, 0 into the constructor",
  nan: "NaN into the constructor",
  axisAngleZ: "+0.3 rad about z",
  axisAngleZMatrix: "+0.3 rad about z, as a matrix",
  fromMatrix: "of twelve matrices",
  slerpPositive: "slerp from a to b, half way",
  slerpNegative: "slerp from a to −b, half way",
  inverse0: "inverse of 0",
  normalize0: "0 normalised",
  euler: "Euler angles",
  other: "besides",
};
