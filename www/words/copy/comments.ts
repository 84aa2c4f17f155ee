// What copied code says of itself. It goes into source files: plain ASCII.
import type { Direction } from "../../engine.ts";
import type { Copied, CopiedEuler, CopiedQuaternion } from "../../model/copied.ts";
import type { CodeFormat } from "../../model/copy_formats.ts";
import { isNormOne } from "../../number/format.ts";
import { lettersOf } from "../conventions.ts";

export const directionWords: Record<Direction, string> = {
  "body-to-world": "body to world",
  "world-to-body": "world to body",
};

/** Coordinates on which axes to coordinates on which a matrix takes. */
export const takesWords: Record<Direction, string> = {
  "body-to-world": "columns of coordinates in the body frame to coordinates in the world frame",
  "world-to-body": "columns of coordinates in the world frame to coordinates in the body frame",
};

export const productWords = { right: "ij = k", left: "ij = -k" } as const;
const conventionNames = { right: "Hamilton", left: "JPL" } as const;

/** What a library does with a quaternion. */
interface Library {
  name: string;
  /** The place of the numbers in its line of code. */
  takes: string;
  /** Its call for the matrix, or words for it. */
  matrix: string;
}

const libraries: Partial<Record<CodeFormat, Library>> = {
  eigen: {
    name: "Eigen",
    takes: "Quaterniond takes w x y z",
    matrix: "toRotationMatrix()",
  },
  scipy: {
    name: "SciPy",
    takes: "from_quat takes x y z w",
    matrix: "as_matrix()",
  },
  ros: {
    name: "ROS",
    takes: "geometry_msgs/Quaternion has x y z w by name",
    matrix: "the rotation matrix",
  },
  nalgebra: {
    name: "nalgebra",
    takes: "Quaternion::new takes w x y z",
    matrix: "to_rotation_matrix()",
  },
  three: {
    name: "three.js",
    takes: "Quaternion takes x y z w",
    matrix: "makeRotationFromQuaternion",
  },
  matlab: {
    name: "MATLAB",
    takes: "quaternion takes w x y z",
    matrix: 'rotmat(q, "point")',
  },
};

function quaternionSays(value: CopiedQuaternion, format: CodeFormat): string[] {
  const { norm, convention, symbol } = value;
  const { handedness, function: does, direction, order } = convention;
  const library = libraries[format];
  const name = conventionNames[handedness];
  const labels = `${does === "active" ? "active, " : ""}${directionWords[direction]}`;
  return [
    library === undefined
      ? `${symbol}: ${name} (${productWords[handedness]}), ${lettersOf[order]}, ${labels}`
      : `${symbol}: ${name} (${productWords[handedness]}), ${labels}; ${library.takes}`,
    ...(library === undefined ? [] : libraryMatrix(value, library)),
    ...(isNormOne(norm) ? [] : [`its norm is ${norm ?? "beyond a double"}, not 1`]),
  ];
}

/** What the library makes of the numbers, where that is not what the convention says anyway. */
function libraryMatrix(
  { convention, hamiltonMatrix, norm }: CopiedQuaternion,
  library: Library,
): string[] {
  // Not every library does that by itself.
  const them = isNormOne(norm) ? "them" : "them, normalized,";
  const direction = directionWords[hamiltonMatrix];
  if (convention.handedness === "left") {
    return [
      `the numbers as they are: ${library.name} multiplies ij = k, so ${library.matrix} of ${them} is R(q) = C(q)^T, ${direction}`,
    ];
  }
  return convention.function === "active"
    ? [`${library.matrix} of ${them} is R(q), for coordinates ${direction}`]
    : [];
}

const frames = {
  intrinsic: "about the moving axes (intrinsic)",
  extrinsic: "about the fixed axes (extrinsic)",
};

/** `ZYX` about the moving axes, `zyx` about the fixed ones, as SciPy writes them. */
export function sequenceLetters({ sequence: { axes, frame } }: CopiedEuler): string {
  return frame === "intrinsic" ? axes.toUpperCase() : axes;
}

const carries =
  "the turn carries the world axes onto the body axes; its matrix is R(q), body to world";

/** What a value is, one sentence a line. */
export function says(value: Copied, format: CodeFormat): string[] {
  switch (value.kind) {
    case "quaternion":
      return quaternionSays(value, format);
    case "matrix":
      return [`${value.symbol}: ${value.does}`];
    case "vector":
      return [`${value.symbol}: ${value.on}`];
    case "axis-angle":
      return [`axis and angle in radians: ${carries}`];
    case "rotation-vector":
      return [`rotation vector (angle times axis) in radians: ${carries}`];
    case "euler":
      return [
        `Euler angles ${sequenceLetters(value)} in radians, ${frames[value.sequence.frame]}: ${carries}`,
      ];
  }
}
