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

/** Four numbers in an order. */
export function arrayOf(
  components: Readonly<Record<ComponentName, number>>,
  order: ComponentOrder,
): number[] {
  return namesOf[order].map((name) => components[name]);
}
