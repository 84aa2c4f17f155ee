// What a convention is called, and which preset it is like.
import { type Axis, axes, type PageState, type Preset } from "../address.ts";
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

export const namedConventions = Object.keys(conventionNames) as (keyof typeof conventionNames)[];

/** Which of the conventions that have a name it is; the perturbation is none of its business. */
export function namedOf(
  convention: Convention,
  engine: Engine,
): keyof typeof conventionNames | undefined {
  return namedConventions.find((name) => agree(["order", ...actions], engine[name], convention));
}

/** The axes in which a convention differs from a preset; what is as in it is no choice of its own. */
export function differing(convention: Convention, base: Convention): Partial<Convention> {
  const names = axes.filter((name) => convention[name] !== base[name]);
  return Object.fromEntries(names.map((name) => [name, convention[name]]));
}

/** What a named convention declares: the preset of its product, its axes, and the matrix beside it. */
export function declarationOf(
  name: (typeof namedConventions)[number],
  engine: Engine,
): Pick<PageState, "preset" | "axes" | "matrix"> {
  const convention = engine[name];
  const preset = presetOf[convention.handedness];
  // “My Lab” pairs its quaternion with the passive matrix of the same direction.
  const direction = name === "myLab" ? convention.direction : "body-to-world";
  return {
    preset,
    axes: differing(convention, engine[preset]),
    matrix: { function: "passive", direction },
  };
}

/** The name of a convention that has one. */
export function nameOf(convention: Convention, engine: Engine): string | undefined {
  const named = namedOf(convention, engine);
  return named && conventionNames[named];
}
