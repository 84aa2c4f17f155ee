// The names of the texts and of the two presets; the same words everywhere on the page.
import { type Axis, axes, type Preset } from "../address.ts";
import type {
  ComponentOrder,
  Convention,
  Direction,
  Engine,
  Field,
  Handedness,
} from "../engine.ts";

/** What a text is called in formulas. */
export const symbolOf: Record<Field, string> = {
  quaternion: "q",
  p: "p",
  q: "q",
  vector: "x",
  from: "from",
  to: "to",
  "world-axes": "world axes",
  "body-axes": "body axes",
  a: "a",
  b: "b",
  matrix: "M",
  "rotation-vector": "φ",
  printed: "printed",
};

/** The preset that has a product. */
export const presetOf: Record<Handedness, Preset> = { right: "hamilton", left: "jpl" };

/** The four numbers in an order. */
export const lettersOf: Record<ComponentOrder, string> = {
  "scalar-first": "w x y z",
  "scalar-last": "x y z w",
};

const arrows: Record<Direction, string> = {
  "body-to-world": "body → world",
  "world-to-body": "world → body",
};

/** A direction as it stands beside a matrix. */
export const arrowOf = (direction: Direction) => arrows[direction];

/** What the two presets are called and do. */
export const wordsOf = {
  hamilton: {
    name: "Hamilton",
    meaning: "w x y z, ij = k, body to world",
    matrix: "R",
    product: "ij = k",
    order: "[w, x, y, z]",
    direction: "body → world",
    reversed: "world → body",
    effect: "Takes coordinates in the body frame to coordinates in the world frame.",
    vector: "x on the body axes, seen in the world",
  },
  jpl: {
    name: "JPL",
    meaning: "x y z w, ij = −k, world to body",
    matrix: "C",
    product: "ij = −k",
    order: "[x, y, z, w]",
    direction: "world → body",
    reversed: "body → world",
    effect: "Takes coordinates in the world frame to coordinates in the body frame.",
    vector: "x on the world axes, seen in the body",
  },
} as const;

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
    asks: "where the scalar stands",
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
    asks: "whose axes a small turn is on",
    values: {
      local: ["local", "on the axes of the body"],
      global: ["global", "on the axes of the world"],
    },
  },
};

/** The word of a value, and what it does. */
export function valueWords(axis: Axis, value: string): [string, string] {
  const words: Record<string, [string, string]> = axisWords[axis].values;
  return words[value] ?? [value, ""];
}

/** A convention in its five words. */
export function fiveWords(convention: Convention): string {
  return axes.map((axis) => valueWords(axis, convention[axis])[0]).join(", ");
}

/** The direction of the matrix that a quaternion acts with: the active one is the inverse. */
export function operatorOf({
  function: does,
  direction,
}: Pick<Convention, "function" | "direction">): Direction {
  if (does === "passive") return direction;
  return direction === "body-to-world" ? "world-to-body" : "body-to-world";
}

/** What decides the matrix and the product of a convention. */
const actions = ["handedness", "function", "direction"] as const;

function agree(names: readonly Axis[], one: Convention, other: Convention): boolean {
  return names.every((axis) => one[axis] === other[axis]);
}

/** The preset that says the same as a convention, but for the places of the numbers and small turns. */
export function presetLike(convention: Convention, engine: Engine): Preset | undefined {
  return (["hamilton", "jpl"] as const).find((preset) =>
    agree(actions, engine[preset], convention),
  );
}

/** The name of a convention that has one; the perturbation is none of its business. */
export function nameOf(convention: Convention, engine: Engine): string | undefined {
  const { hamilton, jpl } = engine;
  const known: [string, Convention][] = [
    ["Hamilton", hamilton],
    ["JPL", jpl],
    ["Hamilton as Eigen and ROS store it", { ...hamilton, order: "scalar-last" }],
    ["JPL of Yoosefian 2021, eq. 18", { ...jpl, direction: "body-to-world" }],
    [
      "“My Lab” of the field guide",
      { ...hamilton, function: "active", direction: "world-to-body" },
    ],
  ];
  return known.find(([, other]) => agree(["order", ...actions], other, convention))?.[0];
}
