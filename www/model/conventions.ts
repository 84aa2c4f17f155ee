// The five axes of a convention, the preset it is like, and the conventions that have a name.
import type { Convention, Direction, Engine, Handedness } from "../engine.ts";
import type { PageState, Preset } from "./page_state.ts";

/** The values of each axis, as the fragment and the core name them. */
export const axisValues = {
  order: ["scalar-first", "scalar-last"],
  handedness: ["right", "left"],
  function: ["passive", "active"],
  direction: ["body-to-world", "world-to-body"],
  perturbation: ["local", "global"],
} as const satisfies { [Axis in keyof Convention]: readonly Convention[Axis][] };

export type Axis = keyof typeof axisValues;
export const axes = Object.keys(axisValues) as Axis[];

/** The preset that has a product. */
export const presetOf: Record<Handedness, Preset> = { right: "hamilton", left: "jpl" };

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

/** The conventions that have a name, in the order in which they are offered. */
export const namedConventions = [
  ...(["hamilton", "jpl", "hamiltonScalarLast", "jplBodyToWorld", "myLab"] as const),
] satisfies (keyof Engine)[];
export type NamedConvention = (typeof namedConventions)[number];

/** Which of the conventions that have a name it is; the perturbation is none of its business. */
export function namedOf(convention: Convention, engine: Engine): NamedConvention | undefined {
  return namedConventions.find((name) => agree(["order", ...actions], engine[name], convention));
}

/** The axes in which a convention differs from a preset; what is as in it is no choice of its own. */
export function differing(convention: Convention, base: Convention): Partial<Convention> {
  const names = axes.filter((name) => convention[name] !== base[name]);
  return Object.fromEntries(names.map((name) => [name, convention[name]]));
}

/** What a named convention declares: the preset of its product, its axes, and the matrix beside it. */
export function declarationOf(
  name: NamedConvention,
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
