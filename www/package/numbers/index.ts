// The entry `quatlas/rotation`: numbers in, numbers out, and no text.
export type {
  Convention,
  Direction,
  EulerAxes,
  EulerFrame,
  IncrementSign,
  Perturbation,
  RateAxes,
  Side,
  Survivor,
} from "../../../pkg/quatlas.js";
export * from "../conventions.ts";
export { type ErrorCode, QuatlasError } from "../quatlas_error.ts";
export type { AxisAngle, EulerAngles, RotationLike } from "./attitude.ts";
export type { Numbers, Quaternion4, Rows3, Vector3 } from "./checks.ts";
export type { AngleUnit, Sequence } from "./choices.ts";
export { Pose, type PoseParts, type PoseRows } from "./pose.ts";
export { type NearestRotation, Rotation } from "./rotation.ts";
export { type Rows4, rateMatrix, TaggedQuaternion } from "./tagged_quaternion.ts";
