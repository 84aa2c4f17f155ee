// ROS messages as YAML: geometry_msgs/Quaternion and geometry_msgs/Vector3.
import { namesOf } from "../../model/component_order.ts";
import { float } from "./numbers.ts";
import type { Writer } from "./writer.ts";

export const ros: Writer = {
  comment: "#",
  lines: {
    quaternion: ({ components }) =>
      namesOf["scalar-last"].map((name) => `${name}: ${float(components[name])}`),
    vector: ({ numbers }) =>
      ["x", "y", "z"].map((name, at) => `${name}: ${float(numbers[at] ?? 0)}`),
  },
};
