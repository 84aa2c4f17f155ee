// The examples of the gallery: what each is called, and what it teaches.
import type { ExampleName } from "../../model/examples/gallery.ts";
import type { View } from "../../model/page_state.ts";
import { featuredNames } from "./featured.ts";

export const groupWords: Record<View, string> = {
  read: "Read: one attitude",
  compose: "Compose: two in a row",
  motion: "Motion: a small turn, a rate, and time",
  frames: "Frames: where one stands in another",
  translate: "Translate: between libraries",
  identify: "Identify: what a library does",
  libraries: "Libraries",
};

export const exampleWords: Record<ExampleName, [name: string, teaches: string]> = {
  "turn-about-z": [
    "45° about z",
    "The planar rotation of the lecture: R(q) and C(q) are each other's transpose.",
  ],
  "jpl-log": [
    featuredNames["jpl-log"],
    "x y z w, world to body: the matrix of the log is C(q), and nothing is conjugated.",
  ],
  "ros-message": [
    featuredNames["ros-message"],
    "Named components need no order: the names decide, wherever w stands.",
  ],
  "yaw-pitch-roll": [
    featuredNames["yaw-pitch-roll"],
    "Three angles about the moving axes z, y, x become one quaternion.",
  ],
  matrix: [featuredNames.matrix, "Nine numbers, row by row: the quaternion that they are."],
  "axis-and-angle": ["Axis and angle", "The axis may have any length; only its line counts."],
  "third-of-a-turn": ["120° about [1 1 1]", "x becomes y, y becomes z, z becomes x."],
  "transposed-matrix": [
    "My matrix is transposed",
    "A matrix from world to body is C(q): look which of the two, R(q) or C(q), has your rows.",
  ],
  "double-cover": [
    "q and −q",
    "Double cover: every sign is flipped, and every matrix is that of 45° about z.",
  ],
  "gimbal-lock": [
    "Gimbal lock",
    "Pitch 90°: yaw and roll turn about one line, so only their difference is left.",
  ],
  "half-turn": ["A half turn", "The matrix is its own transpose, so it cannot show a convention."],
  "invisible-order": [
    "An order that cannot be seen",
    "0.5 0.5 0.5 0.5 is the same in both orders: a bad number to test with.",
  ],
  "norm-of-two": [
    "A norm that is not 1",
    "The inverse is the conjugate divided by the squared norm; the matrices use q/|q|.",
  ],
  "my-lab": [
    "“My Lab” of the field guide",
    "Active, world to body, with a passive matrix beside it: Hamilton's numbers, and their C(q).",
  ],
  random: [
    "A random attitude",
    "Another one each time, every attitude as likely as any other: a good number to test with.",
  ],
  "jpl-body-to-world": [
    "JPL, stated body to world",
    "Here the same matrix does need the conjugate (Yoosefian 2021, eq. 18).",
  ],
  "both-orders": [
    "Both products, both orders",
    "p ⊙ q has the numbers of q ⊗ p: the products differ by the order of their operands.",
  ],
  commuting: [
    "Two rotations that commute",
    "About one axis the order does not matter, so it cannot be tested with them.",
  ],
  "isaac-lab": [
    "Isaac Lab 2 to 3",
    "From w x y z to x y z w: reordered, and nothing is conjugated.",
  ],
  "msckf-log": [
    "A line of an MSCKF log to Eigen",
    "JPL and Hamilton at their customary directions: not even the order changes.",
  ],
  "px4-to-ros": [
    "PX4 to ROS",
    "From north-east-down to east-north-up: the order and the axes of world and body change.",
  ],
  "unknown-library": [
    "A library that says nothing",
    "Three printed results tell its product, its matrix and its order.",
  ],
  "unknown-angles": [
    "Angles without a sequence",
    "Three numbers beside a quaternion: of all sequences, units and orders one fits.",
  ],
};
