// What stands of the examples in the Read view.
import type { FeaturedName } from "../../model/examples/featured.ts";

export const examplesLabel = "Examples";
export const moreExamples = "More examples";

export const featuredNames: Record<FeaturedName, string> = {
  "jpl-log": "JPL filter log",
  "ros-message": "ROS message",
  "yaw-pitch-roll": "Yaw, pitch, roll",
  matrix: "Matrix",
};
