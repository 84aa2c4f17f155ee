// MATLAB, with its toolboxes for quaternions.
import { arrayOf } from "../../model/component_order.ts";
import { factors, listed, plain, unitOf } from "./numbers.ts";
import type { Writer } from "./writer.ts";

const spaced = (numbers: readonly number[]) => listed(numbers, plain, " ");

export const matlab: Writer = {
  comment: "%",
  lines: {
    quaternion: ({ components }) => [
      `q_wxyz = quaternion(${listed(arrayOf(components, "scalar-first"), plain)});`,
    ],
    matrix: ({ rows }) => [`M = [${rows.map(spaced).join("; ")}];`],
    vector: ({ numbers }) => [`v = [${listed(numbers, plain, "; ")}];`],
    "axis-angle": ({ axis, angleRad }) => [`axang = [${spaced([...axis, angleRad])}];`],
    "rotation-vector": ({ vectorRad }) => [`q = quaternion([${spaced(vectorRad)}], "rotvec");`],
    euler: ({ sequence: { axes, frame }, anglesRad }) => [
      `R = ${factors(axes, frame, anglesRad)
        .map(({ axis, angle }) => `axang2rotm([${spaced([...unitOf(axis), angle])}])`)
        .join(" * ")};`,
    ],
  },
};
