// The texts of axis mappings; pure.
import type { AxisMapping } from "./engine.ts";

/** Changes of axes that people need, for both sides. */
export const axisPresets = [
  "NED to ENU",
  "ENU to NED",
  "FRD to FLU",
  "FLU to FRD",
  "ROS to Unity",
  "Unity to ROS",
  "ROS to Unreal",
  "Unreal to ROS",
  "ROS to OpenCV",
  "OpenCV to ROS",
  "OpenCV to OpenGL",
  "OpenGL to OpenCV",
] as const;

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

/** The text of the mapping back. */
export function inverseAxes(text: string, mapping: AxisMapping | undefined): string {
  if (text.trim() === "" || mapping === undefined) return text;
  const [from, to, ...rest] = text.split(/\s+to\s+|\s*(?:->|→)\s*/i);
  if (from && to && rest.length === 0) return `${to.trim()} to ${from.trim()}`;
  return (["x", "y", "z"] as const)
    .map((old) => {
      const at = mapping.axes.findIndex(({ axis }) => axis === old);
      return `${mapping.axes[at]?.sense === "against" ? "-" : ""}${"xyz"[at]}`;
    })
    .join(" ");
}
