// C++ with Eigen.
import { arrayOf } from "../../model/component_order.ts";
import type { Rows } from "../../model/copied.ts";
import { factors, float, listed } from "./numbers.ts";
import type { Writer } from "./writer.ts";

const vector = (numbers: readonly number[]) => `Eigen::Vector3d(${listed(numbers, float)})`;

export const eigen: Writer = {
  comment: "//",
  lines: {
    quaternion: ({ components }) => [
      `Eigen::Quaterniond q(${listed(arrayOf(components, "scalar-first"), float)});`,
    ],
    matrix: ({ rows }) => {
      const [first = "", ...rest] = rows.map((row) => listed(row, float));
      return [
        `${matrixType(rows)} M;`,
        `M << ${[first, ...rest.map((row) => `     ${row}`)].join(",\n")};`,
      ];
    },
    vector: ({ numbers }) => [`Eigen::Vector${numbers.length}d v(${listed(numbers, float)});`],
    "axis-angle": ({ axis, angleRad }) => [
      `Eigen::AngleAxisd r(${float(angleRad)}, ${vector(axis)});`,
    ],
    "rotation-vector": ({ vectorRad }) => [
      `Eigen::Vector3d v(${listed(vectorRad, float)});`,
      "Eigen::AngleAxisd r(v.norm(), v.normalized());",
    ],
    euler: ({ sequence: { axes, frame }, anglesRad }) => [
      `Eigen::Quaterniond q = ${factors(axes, frame, anglesRad)
        .map(({ axis, angle }) => `Eigen::AngleAxisd(${float(angle)}, ${unitCall(axis)})`)
        .join(" * ")};`,
    ],
  },
};

function matrixType({ length, 0: first }: Rows): string {
  const columns = first?.length ?? length;
  return columns === length
    ? `Eigen::Matrix${length}d`
    : `Eigen::Matrix<double, ${length}, ${columns}>`;
}

const unitCall = (axis: string) => `Eigen::Vector3d::Unit${axis.toUpperCase()}()`;
