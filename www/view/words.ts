// The names of the texts and of the two presets; the same words everywhere on the page.
import type { Preset } from "../address.ts";
import type { Field, Handedness } from "../engine.ts";

/** What a text is called in formulas. */
export const symbolOf: Record<Field, string> = { quaternion: "q", p: "p", q: "q", vector: "x" };

/** The preset that has a product. */
export const presetOf: Record<Handedness, Preset> = { right: "hamilton", left: "jpl" };

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
