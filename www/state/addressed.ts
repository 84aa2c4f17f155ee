// The state as the address holds it: what is pasted whole makes no endless address.
import type { Engine, ReadQuaternion } from "../engine.ts";
import { declaredConvention } from "../model/conventions.ts";
import type { PageState } from "../model/page_state.ts";

/** The longest text that the address holds as it is, in characters. */
const longestInAddress = 8192;

/** What the core answers to a state; nothing where its view asks nothing. */
export type Answer = ReturnType<Engine["analyze"]> | undefined;

/** The texts of rotations. */
const rotationTexts = ["quaternion", "p", "q", "translated"] as const;
type RotationText = (typeof rotationTexts)[number];

/**
 * The state with the numbers that were read in place of each text that is too long for an address; the
 * state itself where there is none. A text that tells its direction stays where the numbers alone would
 * be another rotation and there is nothing to declare for it alone.
 */
export function addressed(state: PageState, answer: Answer): PageState {
  let shortened = state;
  for (const name of rotationTexts) {
    const read = state[name].length > longestInAddress ? readOf(name, answer) : undefined;
    if (read === undefined) continue;
    // What a text may tell of its convention besides the order, which the names tell.
    const { direction } = read.convention;
    const isDeclared = direction === directionAlone(state, answer);
    if (!isDeclared && name !== "quaternion") continue;
    const axes = isDeclared ? shortened.axes : { ...shortened.axes, direction };
    shortened = { ...shortened, [name]: namedNumbers(read), axes };
  }
  return shortened;
}

function readOf(name: RotationText, answer: Answer): ReadQuaternion | undefined {
  switch (answer?.status) {
    case "read":
    case "motion":
      return name === "quaternion" ? answer.quaternion : undefined;
    case "compose":
      return name === "p" || name === "q" ? answer[name] : undefined;
    case "translate":
      return name === "translated" ? answer.quaternion : undefined;
    default:
      return undefined;
  }
}

/** The direction of numbers that do not tell it. */
const directionAlone = (state: PageState, answer: Answer) =>
  answer?.status === "translate"
    ? answer.from.convention.direction
    : declaredConvention(state).direction;

function namedNumbers({ components: { w, x, y, z } }: ReadQuaternion): string {
  return `w=${w} x=${x} y=${y} z=${z}`;
}
