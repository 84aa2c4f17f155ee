// The eight choices that describe what a library does, in the order in which they are shown.
import type {
  BehaviourAxis,
  ComponentOrder,
  ComponentSign,
  CosineMatrix,
  Family,
  Handedness,
  IncrementSign,
  Perturbation,
  Remaining,
} from "../engine.ts";
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
  constructor: ["scalar-first", "scalar-last"],
  array: ["scalar-first", "scalar-last"],
  handedness: ["right", "left"],
  rotate: ["R", "C"],
  matrix: ["R", "C"],
  attitude: ["canonical", "conjugated"],
  perturbation: ["local", "global"],
  incrementSign: ["physical", "formal"],
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

/** What product and rotation make together, once both are settled. */
export function settledFamily({ handedness, rotate }: Remaining): Family | undefined {
  if (handedness.length !== 1 || rotate.length !== 1) return undefined;
  if (handedness[0] === "right") return rotate[0] === "R" ? "hamilton" : "transposed-matrix";
  return rotate[0] === "C" ? "shuster" : "reversed-product";
}
