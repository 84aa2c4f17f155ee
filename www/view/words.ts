// The names of the two presets, and what they do.
import type { Preset } from "../address.ts";
import type { Handedness } from "../engine.ts";

/** The preset that has a product. */
export const presetOf: Record<Handedness, Preset> = { right: "hamilton", left: "jpl" };

/** What the two presets are called and do; the same words everywhere on the page. */
export const wordsOf = {
  hamilton: {
    name: "Hamilton",
    matrix: "R",
    other: "C",
    product: "ij = k",
    order: "[w, x, y, z]",
    direction: "body → world",
    reversed: "world → body",
    effect: "Takes coordinates in the body frame to coordinates in the world frame.",
    vector: "x on the body axes, seen in the world",
  },
  jpl: {
    name: "JPL",
    matrix: "C",
    other: "R",
    product: "ij = −k",
    order: "[x, y, z, w]",
    direction: "world → body",
    reversed: "body → world",
    effect: "Takes coordinates in the world frame to coordinates in the body frame.",
    vector: "x on the world axes, seen in the body",
  },
} as const;
