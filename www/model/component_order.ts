// The two orders of four numbers.
import type { ComponentOrder } from "../engine.ts";

export type ComponentName = "w" | "x" | "y" | "z";

/** The name of each number in an order. */
export const namesOf = {
  "scalar-first": ["w", "x", "y", "z"],
  "scalar-last": ["x", "y", "z", "w"],
} as const satisfies Record<ComponentOrder, readonly ComponentName[]>;

/** The names with a space between them: what is written by hand in this type cannot differ from them. */
export type Letters = {
  [Order in ComponentOrder]: Joined<(typeof namesOf)[Order]>;
};
type Joined<Names extends readonly string[]> = Names extends readonly [
  infer First extends string,
  ...infer Rest extends readonly string[],
]
  ? Rest extends readonly []
    ? First
    : `${First} ${Joined<Rest>}`
  : never;

/** The order that an order is not. */
export const otherOrder: Record<ComponentOrder, ComponentOrder> = {
  "scalar-first": "scalar-last",
  "scalar-last": "scalar-first",
};

/**
 * What stands before each name where numbers are written as text: of a norm far from 1 the core asks
 * whether they are a quaternion at all, which `qw` says and `w` does not.
 */
export function markOf({ w, x, y, z }: Readonly<Record<ComponentName, number>>): "" | "q" {
  return Math.abs(Math.hypot(w, x, y, z) - 1) < 0.1 ? "" : "q";
}

/** Four numbers in an order. */
export function arrayOf(
  components: Readonly<Record<ComponentName, number>>,
  order: ComponentOrder,
): number[] {
  return namesOf[order].map((name) => components[name]);
}
