// All English of the page stands in this folder, one file for each part of the page, plurals and the
// order of words included: who translates the page edits these files and no other. Only index.html,
// which is read before any script, has its own. Symbols, formulas and the letters of mathematics may
// stand in the views.
//
// One word for one thing: a rotation is what q is; to turn is what a body, an axis or a vector does, and
// as a noun a turn is only an amount (half a turn) or what a picture shows in motion. A text is fixed, an
// axis is flipped, a frame has a handedness, and what is shown while a text has a problem is the last
// valid result.
//
// Here: what the texts, the two presets and the five axes are called; the same everywhere.
import type { Convention, Direction, Field, NamedConvention } from "../engine.ts";
import type { Letters } from "../model/component_order.ts";
import type { Axis } from "../model/conventions.ts";

/** What a text is called in formulas. */
export const symbolOf: Record<Field, string> = {
  quaternion: "q",
  p: "p",
  q: "q",
  vector: "v",
  from: "from",
  to: "to",
  "world-axes": "world axes",
  "body-axes": "body axes",
  a: "a",
  b: "b",
  matrix: "M",
  "rotation-vector": "φ",
  printed: "printed",
  numbers: "numbers",
  yawed: "yawed",
  product: "product",
  part: "t",
  factor: "factor",
  axis: "axis",
  parent: "parent",
  child: "child",
  rotation: "rotation",
  position: "position",
  point: "point",
  rate: "ω",
  "rate-end": "ω₁",
  duration: "t",
  increment: "δ",
  covariance: "P",
};

/** The four numbers in an order. */
export const lettersOf: Letters = {
  "scalar-first": "w x y z",
  "scalar-last": "x y z w",
};

const arrows: Record<Direction, string> = {
  "body-to-world": "body → world",
  "world-to-body": "world → body",
};

/** A direction as it stands beside a matrix. */
export const arrowOf = (direction: Direction) => arrows[direction];

/** On what stands in the declared convention. */
export const asDeclared = "as declared";

/** What the two presets are called and do. */
export const wordsOf = {
  hamilton: {
    name: "Hamilton",
    meaning: "w x y z · body → world",
    matrix: "R",
    product: "ij = k",
    order: "[w, x, y, z]",
    direction: "body → world",
    reversed: "world → body",
    vector: "v on the body axes, seen in the world",
  },
  jpl: {
    name: "JPL",
    meaning: "x y z w · world → body",
    matrix: "C",
    product: "ij = −k",
    order: "[x, y, z, w]",
    direction: "world → body",
    reversed: "body → world",
    vector: "v on the world axes, seen in the body",
  },
} as const;

/** What the conventions are called that have a name. */
export const conventionNames: Record<NamedConvention, string> = {
  hamilton: "Hamilton",
  jpl: "JPL",
  hamiltonScalarLast: "Hamilton as Eigen and ROS store it",
  jplBodyToWorld: "JPL of Yoosefian 2021, eq. 18",
  myLab: "“My Lab” of the field guide",
};

/** What the values of each axis are called, and what they do. */
export const axisWords: {
  [Name in Axis]: {
    name: string;
    asks: string;
    values: Record<Convention[Name], [string, string]>;
  };
} = {
  order: {
    name: "Order",
    asks: "where the scalar is",
    values: {
      "scalar-first": ["scalar first", "[w, x, y, z]"],
      "scalar-last": ["scalar last", "[x, y, z, w]"],
    },
  },
  handedness: {
    name: "Handedness",
    asks: "which product",
    values: {
      right: ["right", "ij = k: p ⊙ q, Hamilton"],
      left: ["left", "ij = −k: p ⊗ q, JPL (Shuster)"],
    },
  },
  function: {
    name: "Function",
    asks: "what moves",
    values: {
      passive: ["passive", "the vector stays, its coordinates change"],
      active: ["active", "the axes stay, the vector moves"],
    },
  },
  direction: {
    name: "Direction",
    asks: "from which frame to which",
    values: {
      "body-to-world": ["body to world", "from the body frame to the world frame"],
      "world-to-body": ["world to body", "from the world frame to the body frame"],
    },
  },
  perturbation: {
    name: "Perturbation",
    asks: "the axes of a small rotation",
    values: {
      local: ["local", "about the axes of the body"],
      global: ["global", "about the axes of the world"],
    },
  },
};
