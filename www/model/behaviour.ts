// The eight choices that describe what a library does, in the order in which they are shown.
import type {
  BehaviourAxis,
  ComponentOrder,
  ComponentSign,
  Convention,
  CosineMatrix,
  Handedness,
  IncrementSign,
  Perturbation,
  Remaining,
} from "../engine.ts";
import {
  componentOrderValues,
  componentSignValues,
  cosineMatrixValues,
  handednessValues,
  incrementSignValues,
  namedConventions,
  perturbationValues,
} from "../values.ts";
import type { Preset } from "./page_state.ts";

/** The values of each choice. */
export interface ChoiceValues {
  constructor: ComponentOrder;
  array: ComponentOrder;
  handedness: Handedness;
  rotate: CosineMatrix;
  matrix: CosineMatrix;
  attitude: ComponentSign;
  perturbation: Perturbation;
  incrementSign: IncrementSign;
}

/** First what the library does, then how its user means an attitude. */
export const choicesOfLibrary = [
  ...(["constructor", "array", "handedness", "rotate", "matrix"] as const),
] satisfies BehaviourAxis[];
export const choicesOfUse: readonly BehaviourAxis[] = ["attitude", "perturbation", "incrementSign"];

/** Both values of each choice. */
export const valuesOf: {
  [Choice in BehaviourAxis]: readonly [ChoiceValues[Choice], ChoiceValues[Choice]];
} = {
  constructor: componentOrderValues,
  array: componentOrderValues,
  handedness: handednessValues,
  rotate: cosineMatrixValues,
  matrix: cosineMatrixValues,
  attitude: componentSignValues,
  perturbation: perturbationValues,
  incrementSign: incrementSignValues,
};

/** The convention that has a value as its own. */
export const presetOfValue: Readonly<Record<string, Preset | undefined>> = {
  right: "hamilton",
  left: "jpl",
  R: "hamilton",
  C: "jpl",
};

/** The value of a choice that is left; nothing while both are, or none. */
export function settledValue(remaining: Remaining, choice: BehaviourAxis): string | undefined {
  const values: readonly string[] = remaining[choice];
  return values.length === 1 ? values[0] : undefined;
}

/**
 * The convention that the numbers of a library follow; nothing until their order and what they do to a
 * vector are settled. What else is open is as it is customary.
 */
export function settledConvention(remaining: Remaining): Convention | undefined {
  const order = only(remaining.array);
  const rotate = only(remaining.rotate);
  if (order === undefined || rotate === undefined) return undefined;
  const customary = namedConventions[rotate === "R" ? "hamilton" : "jpl"];
  return {
    ...customary,
    order,
    direction: only(remaining.direction) ?? customary.direction,
    perturbation: only(remaining.perturbation) ?? customary.perturbation,
  };
}

function only<Value>(values: readonly Value[]): Value | undefined {
  return values.length === 1 ? values[0] : undefined;
}
