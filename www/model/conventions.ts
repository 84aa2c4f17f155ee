// The five axes of a convention, and the preset of its product.
import type {
  Convention,
  Direction,
  Handedness,
  MatrixConvention,
  NamedConvention,
} from "../engine.ts";
import {
  componentOrderValues,
  directionValues,
  functionValues,
  handednessValues,
  namedConventions,
  operatorDirections,
  perturbationValues,
} from "../values.ts";
import type { PageState, Preset } from "./page_state.ts";

/** The values of each axis. */
export const axisValues = {
  order: componentOrderValues,
  handedness: handednessValues,
  function: functionValues,
  direction: directionValues,
  perturbation: perturbationValues,
} as const satisfies { [Axis in keyof Convention]: readonly Convention[Axis][] };

export type Axis = keyof typeof axisValues;
export const axes = Object.keys(axisValues) as Axis[];

/** The preset that has a product. */
export const presetOf: Record<Handedness, Preset> = { right: "hamilton", left: "jpl" };

/** The direction of the matrix that a function and a direction mean, as the core says it. */
export function operatorOf({ function: does, direction }: MatrixConvention): Direction {
  return operatorDirections[does][direction];
}

/** The axes in which a convention differs from a preset; what is as in it is no choice of its own. */
export function differing(convention: Convention, base: Convention): Partial<Convention> {
  const names = axes.filter((name) => convention[name] !== base[name]);
  return Object.fromEntries(names.map((name) => [name, convention[name]]));
}

/** What a named convention declares: the preset of its product, its axes, and the matrix beside it. */
export function declarationOf(
  name: NamedConvention,
): Pick<PageState, "preset" | "axes" | "matrix"> {
  const convention = namedConventions[name];
  const preset = presetOf[convention.handedness];
  // “My Lab” pairs its quaternion with the passive matrix of the same direction.
  const direction = name === "myLab" ? convention.direction : "body-to-world";
  return {
    preset,
    axes: differing(convention, namedConventions[preset]),
    matrix: { function: "passive", direction },
  };
}

/** What four typed numbers are declared to mean. */
export function declaredConvention({
  preset,
  axes,
}: Pick<PageState, "preset" | "axes">): Convention {
  return { ...namedConventions[preset], ...axes };
}
