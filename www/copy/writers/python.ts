// Python with SciPy's Rotation, and with NumPy alone.
import { arrayOf } from "../../model/component_order.ts";
import type { Rows } from "../../model/copied.ts";
import { sequenceLetters } from "../../words/copy/comments.ts";
import { float, listed, ordered } from "./numbers.ts";
import type { Writer } from "./writer.ts";

const list = (numbers: readonly number[]) => `[${listed(numbers, float)}]`;
const nested = (rows: Rows, indent: string) => `[${rows.map(list).join(`,\n${indent}`)}]`;

export const scipy: Writer = {
  comment: "#",
  lines: {
    quaternion: ({ components }) => [
      `q = Rotation.from_quat(${list(arrayOf(components, "scalar-last"))})`,
    ],
    matrix: ({ rows }) => [`r = Rotation.from_matrix(${nested(rows, " ".repeat(26))})`],
    "axis-angle": ({ axis, angleRad }) => [
      `r = Rotation.from_rotvec(${float(angleRad)} * np.array(${list(axis)}))`,
    ],
    "rotation-vector": ({ vectorRad }) => [`r = Rotation.from_rotvec(${list(vectorRad)})`],
    euler: (value) => [
      `r = Rotation.from_euler("${sequenceLetters(value)}", ${list(value.anglesRad)})`,
    ],
  },
};

export const numpy: Writer = {
  comment: "#",
  lines: {
    quaternion: (value) => {
      const { name, numbers } = ordered(value);
      return [`${name} = np.array(${list(numbers)})`];
    },
    matrix: ({ rows }) => [`M = np.array(${nested(rows, " ".repeat(14))})`],
    vector: ({ numbers }) => [`v = np.array(${list(numbers)})`],
    "axis-angle": ({ axis, angleRad }) => [
      `axis, angle = np.array(${list(axis)}), ${float(angleRad)}`,
    ],
    "rotation-vector": ({ vectorRad }) => [`v = np.array(${list(vectorRad)})`],
    euler: ({ anglesRad }) => [`angles = np.array(${list(anglesRad)})`],
  },
};
