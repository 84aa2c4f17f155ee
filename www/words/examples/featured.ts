// What stands of the examples in the Read view.
import type { FeaturedName } from "../../model/examples/featured.ts";

export const examplesLabel = "Examples";
export const moreExamples = "More examples";

export const featuredNames: Record<FeaturedName, string> = {
  "turn-about-z": "45° about z",
  "jpl-log": "A JPL filter log",
  "ros-message": "A ROS message",
  "yaw-pitch-roll": "Yaw, pitch, roll",
  matrix: "A matrix",
};
