// What a convention is called, by its name or in its five words.
import type { Convention, Engine } from "../../engine.ts";
import { type Axis, axes } from "../../model/conventions.ts";
import type { Preset } from "../../model/page_state.ts";
import { namedConventions } from "../../values.ts";
import { axisWords, conventionNames } from "../../words/conventions.ts";

/** The word of a value, and what it does. */
export function valueWords(axis: Axis, value: string): [string, string] {
  const words: Record<string, [string, string]> = axisWords[axis].values;
  return words[value] ?? [value, ""];
}

/** A convention in its five words. */
export function fiveWords(convention: Convention): string {
  return axes.map((axis) => valueWords(axis, convention[axis])[0]).join(", ");
}

/** The name of a convention that has one. */
export function nameOf(convention: Convention, engine: Engine): string | undefined {
  const { named } = engine.describe(convention);
  return named && conventionNames[named];
}

/** The preset that a convention is: with the same numbers, and in the same places. */
export function presetItself(convention: Convention, engine: Engine): Preset | undefined {
  const { preset } = engine.describe(convention);
  return preset && namedConventions[preset].order === convention.order ? preset : undefined;
}
