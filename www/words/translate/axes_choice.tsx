// The words with which the axes are chosen.
import type { axisPresets } from "../../model/axis_mapping.ts";

/** What each axis of a preset is, for those who do not know the letters. */
export const axisPresetWords: Record<(typeof axisPresets)[number], string> = {
  "NED to ENU": "north, east, down to east, north, up",
  "ENU to NED": "east, north, up to north, east, down",
  "FRD to FLU": "forward, right, down to forward, left, up",
  "FLU to FRD": "forward, left, up to forward, right, down",
  "ROS to Unity": "x forward, z up to left-handed y up",
  "Unity to ROS": "left-handed y up to x forward, z up",
  "ROS to Unreal": "x forward, z up to left-handed z up",
  "Unreal to ROS": "left-handed z up to x forward, z up",
  "ROS to OpenCV": "x forward, z up to z forward, y down",
  "OpenCV to ROS": "z forward, y down to x forward, z up",
  "OpenCV to OpenGL": "y down, z forward to y up, z back",
  "OpenGL to OpenCV": "y up, z back to y down, z forward",
};

export const title = "Axes";

export const lead = (
  <>
    A step of its own, whatever the libraries: the same attitude between axes that point elsewhere.
    Say the new axes in terms of the old, as <code>y x -z</code>, or name two systems, as{" "}
    <code>NED to ENU</code>.
  </>
);

export const side = { world: "Axes of the world", body: "Axes of the body" };
export const field = { world: "axes of the world", body: "axes of the body" };
export const named = { world: "Named axes of the world", body: "Named axes of the body" };
export const sameFor = { world: "Same for the world", body: "Same for the body" };
export const keep = "stay as they are";
export const none = "none";
export const preset = (name: (typeof axisPresets)[number]) => `${name}: ${axisPresetWords[name]}`;
export const keepAll = "Leave all axes as they are";

export const summary = (world: string, body: string) =>
  world === "" && body === ""
    ? "stay as they are"
    : `world ${world || "as it is"}, body ${body || "as it is"}`;
