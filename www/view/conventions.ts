// What a convention is called, and which preset it is like.
import { type Axis, axes, type Preset } from "../address.ts";
import type { Convention, Direction, Engine, Handedness } from "../engine.ts";
import { axisWords, conventionNames } from "../words/conventions.ts";

/** The preset that has a product. */
export const presetOf: Record<Handedness, Preset> = { right: "hamilton", left: "jpl" };

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

/** Which of the conventions that have a name it is; the perturbation is none of its business. */
export function namedOf(
  convention: Convention,
  engine: Engine,
): keyof typeof conventionNames | undefined {
  const { hamilton, jpl } = engine;
  const named: Record<keyof typeof conventionNames, Convention> = {
    hamilton,
    jpl,
    eigen: { ...hamilton, order: "scalar-last" },
    eq18: { ...jpl, direction: "body-to-world" },
    "my-lab": { ...hamilton, function: "active", direction: "world-to-body" },
  };
  return (Object.keys(named) as (keyof typeof named)[]).find((name) =>
    agree(["order", ...actions], named[name], convention),
  );
}

/** The name of a convention that has one. */
export function nameOf(convention: Convention, engine: Engine): string | undefined {
  const named = namedOf(convention, engine);
  return named && conventionNames[named];
}
