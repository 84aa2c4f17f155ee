// Words of conventions, as the core takes them: the place of each in its list.
import type { Convention, EulerAxes, EulerFrame } from "../../../pkg/quatlas.js";
import {
  componentOrderValues,
  directionValues,
  eulerAxesValues,
  eulerFrameValues,
  functionValues,
  handednessValues,
  incrementSignValues,
  perturbationValues,
  rateAxesValues,
  sideValues,
} from "../../../pkg/values.js";
import { QuatlasError } from "../quatlas_error.ts";
import { kindOf, placeOf } from "./checks.ts";

/** The unit of an angle that is given or asked for. */
export type AngleUnit = "rad" | "deg";

/**
 * Three axes: capitals for axes that move with the body (intrinsic), small letters for axes that stay
 * (extrinsic), as in SciPy; or both in words.
 */
export type Sequence = Uppercase<EulerAxes> | EulerAxes | { axes: EulerAxes; frame: EulerFrame };

const members = [
  ["order", componentOrderValues],
  ["handedness", handednessValues],
  ["function", functionValues],
  ["direction", directionValues],
  ["perturbation", perturbationValues],
] as const;

/** What else names a convention; `quatlas` puts the ids of libraries here. */
let named: ((id: string) => Convention) | undefined;

/** From now on an id stands for a convention. */
export function nameConventionsBy(conventionOf: (id: string) => Convention): void {
  named = conventionOf;
}

/** The convention that is meant, with its five members alone. */
export function conventionOf(value: unknown): Convention {
  if (typeof value === "string") {
    if (named !== undefined) return named(value);
    const hint =
      "give a convention such as HAMILTON or JPL; the entry `quatlas` knows libraries by their id";
    throw new QuatlasError("unknown-convention", `the convention is the text "${value}"`, hint);
  }
  if (typeof value !== "object" || value === null) {
    const hint =
      "give HAMILTON, JPL or an object with the five choices; without one, four numbers mean nothing";
    throw new QuatlasError("unknown-convention", `the convention is ${kindOf(value)}`, hint);
  }
  return value as Convention;
}

const known = new WeakMap<object, number>();

/** The five choices of a convention as bits. */
export function codeOf(convention: Convention): number {
  const remembered = known.get(convention);
  if (remembered !== undefined) return remembered;
  let code = 0;
  members.forEach(([member, choices], bit) => {
    const place = (choices as readonly string[]).indexOf(convention[member]);
    if (place < 0) {
      const given = convention[member] === undefined ? "missing" : `"${convention[member]}"`;
      const hint = `write "${choices.join('" or "')}"`;
      throw new QuatlasError(
        "unknown-convention",
        `\`${member}\` of the convention is ${given}`,
        hint,
      );
    }
    code += place * 2 ** bit;
  });
  // Of one that can be changed, it may be another the next time.
  if (Object.isFrozen(convention)) known.set(convention, code);
  return code;
}

export const directionPlace = (value: unknown) => placeOf(value, directionValues, "the direction");
export const perturbationPlace = (value: unknown) =>
  placeOf(value, perturbationValues, "the choice of axes");
export const ratePlace = (value: unknown) => placeOf(value, rateAxesValues, "the axes of the rate");
export const sidePlace = (value: unknown) => placeOf(value, sideValues, "the side");
export const signPlace = (value: unknown) => placeOf(value, incrementSignValues, "the sign");
/** The units are called by their short names here; the core has degrees first. */
export const unitPlace = (value: unknown) => placeOf(value, ["deg", "rad"], "the unit");

/** The places of the axes and of the frame of a sequence. */
export function sequencePlaces(value: unknown): [axes: number, frame: number] {
  const words = typeof value === "string" ? inWords(value) : value;
  if (typeof words === "object" && words !== null && "axes" in words && "frame" in words) {
    const axes = eulerAxesValues.indexOf(words.axes as EulerAxes);
    const frame = eulerFrameValues.indexOf(words.frame as EulerFrame);
    if (axes >= 0 && frame >= 0) return [axes, frame];
  }
  const given = typeof value === "string" ? `"${value}"` : kindOf(value);
  const hint =
    'write three axes, none after itself: "ZYX" about moving axes, "xyz" about fixed ones';
  throw new QuatlasError("unknown-sequence", `the sequence is ${given}`, hint);
}

function inWords(letters: string) {
  const axes = letters.toLowerCase();
  if (letters === axes) return { axes, frame: "extrinsic" };
  return letters === letters.toUpperCase() ? { axes, frame: "intrinsic" } : undefined;
}
