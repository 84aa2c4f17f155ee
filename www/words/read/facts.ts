// The words of what no convention changes: the rotation itself.
import type { EulerFrame } from "../../engine.ts";

export const facts = "The rotation, the same in every convention";
export const axisAndAngle = "Axis and angle";
export const axisAndAngleInRadians = "axis and angle in radians";
export const rotationVector = "Rotation vector";
export const rotationVectorNote = "Angle times axis, in radians.";
export const rotationVectorCopied = "rotation vector";
/** Vectors along the axis whose length is a tangent. */
export const gibbs = {
  name: "Gibbs vector",
  of: "Gibbs vector",
  note: "tan(angle/2) times axis: x y z divided by w, the Rodrigues parameters. Infinite at half a turn.",
};
export const rodrigues = {
  name: "Modified Rodrigues parameters",
  of: "modified Rodrigues parameters",
  note: "tan(angle/4) times axis, of the shorter turn; at half a turn its length is 1.",
};
export const infinite = "infinite: half a turn";
export const oppositeCopied = "minus q";

export const eulerAngles = "Euler angles";
export const eulerAxes = "Euler axes";
export const eulerFrame = "Intrinsic or extrinsic";
export const eulerCopied = (unit: string) => `Euler angles in ${unit}`;
export const frames: Record<EulerFrame, string> = {
  intrinsic: "intrinsic (moving)",
  extrinsic: "extrinsic (fixed)",
};
/** At gimbal lock: what comes before the button. */
export const free = "Another order of the axes is not locked here:";
export const showSequence = (letters: string) => `Show ${letters}`;
/** The angles of intrinsic ZYX. */
export const yawPitchRoll = ["yaw", "pitch", "roll"];
/** The angles of a sequence about these axes that has no names for them. */
export const ordinals = (axes: readonly string[]) =>
  ["first", "second", "third"].map((ordinal, at) => `${ordinal} (${axes[at] ?? ""})`);
