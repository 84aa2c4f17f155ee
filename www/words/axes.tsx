// The words of *More* with its five axes, and of the step that gives the axes other names.
import type { axisPresets } from "../axis_texts.ts";
import type { Direction } from "../engine.ts";
import { arrowOf } from "./conventions.ts";

export const moreWords = {
  more: "More",
  five: "What four typed numbers mean is five choices, each by itself.",
  /** What nine typed numbers are, by the direction of the matrix. */
  matrix: (direction: Direction) => (
    <>
      Nine typed numbers are a matrix, row by row, with a function and a direction of its own:{" "}
      <strong>{arrowOf(direction)}</strong>, its columns are the{" "}
      {direction === "body-to-world" ? "body axes in the world" : "world axes in the body"}.
    </>
  ),
  ofMatrix: "of the matrix",
} as const;

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

export const axesChoiceWords = {
  title: "Axes",
  lead: (
    <>
      A step of its own, whatever the libraries: the same attitude between axes that point
      elsewhere. Say the new axes in terms of the old, as <code>y x -z</code>, or name two systems,
      as <code>NED to ENU</code>.
    </>
  ),
  side: { world: "Axes of the world", body: "Axes of the body" },
  field: { world: "axes of the world", body: "axes of the body" },
  named: { world: "Named axes of the world", body: "Named axes of the body" },
  sameFor: { world: "Same for the world", body: "Same for the body" },
  keep: "stay as they are",
  none: "none",
  preset: (name: (typeof axisPresets)[number]) => `${name}: ${axisPresetWords[name]}`,
  keepAll: "Leave all axes as they are",
  summary: (world: string, body: string) =>
    world === "" && body === ""
      ? "stay as they are"
      : `world ${world || "as it is"}, body ${body || "as it is"}`,
} as const;
