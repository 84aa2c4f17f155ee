// The texts of axis mappings; pure.
import type { AxisMapping } from "../engine.ts";

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
