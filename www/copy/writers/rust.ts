// Rust with nalgebra.
import { arrayOf } from "../../model/component_order.ts";
import type { Rows } from "../../model/copied.ts";
import { isNormOne } from "../../number/format.ts";
import { factors, float, listed } from "./numbers.ts";
import type { Writer } from "./writer.ts";

const vector = (numbers: readonly number[]) =>
  `Vector${numbers.length}::new(${listed(numbers, float)})`;

function matrixType({ length, 0: first }: Rows): string {
  const columns = first?.length ?? length;
  return `Matrix${columns === length ? length : `${length}x${columns}`}`;
}

export const nalgebra: Writer = {
  comment: "//",
  lines: {
    // A `UnitQuaternion` is of norm 1, and `from_quaternion` would make any other so.
    quaternion: ({ components, norm }) => {
      const quaternion = `Quaternion::new(${listed(arrayOf(components, "scalar-first"), float)})`;
      return isNormOne(norm)
        ? [`let q = UnitQuaternion::from_quaternion(${quaternion});`]
        : [`let q = ${quaternion};`];
    },
    // Row by row, although nalgebra keeps its matrices column by column.
    matrix: ({ rows }) => [
      `let m = ${matrixType(rows)}::new(`,
      ...rows.map((row) => `    ${listed(row, float)},`),
      ");",
    ],
    vector: ({ numbers }) => [`let v = ${vector(numbers)};`],
    "axis-angle": ({ axis, angleRad }) => [
      `let q = UnitQuaternion::from_axis_angle(&Unit::new_normalize(${vector(axis)}), ${float(angleRad)});`,
    ],
    "rotation-vector": ({ vectorRad }) => [
      `let q = UnitQuaternion::from_scaled_axis(${vector(vectorRad)});`,
    ],
    euler: ({ sequence: { axes, frame }, anglesRad }) => [
      `let q = ${factors(axes, frame, anglesRad)
        .map(
          ({ axis, angle }) =>
            `UnitQuaternion::from_axis_angle(&Vector3::${axis}_axis(), ${float(angle)})`,
        )
        .join("\n    * ")};`,
    ],
  },
};
