// What is said of three, four or nine numbers beside an attitude.
import type { AngleUnit, Axis, EulerSequence, OtherAxes, Problem, Reading } from "../../engine.ts";
import { lettersOf } from "../conventions.ts";
import { capital, listed } from "../phrases.ts";

export const summary = "Which Euler angles are these?";
export const lead =
  "Three numbers beside a quaternion or a matrix: which sequence, in which unit. Four or nine are compared too, and names as (−q2, q1, −q4, q3).";
export const numbers = "the numbers";
export const attitude = "the attitude";
export const examples = "Examples";
export const exampleNames = {
  engine: "x, y, z of a game engine",
  rewriting: "A rewriting",
  matrix: "Nine numbers",
};
export const readings = "The readings that come nearest";
export const read = "Read this";
export const fits = "fits";
export const off = (angle: string) => `${angle} off`;

/** What the numbers are, how many readings fit, or how far the nearest is. */
export const only = (reading: string, next: string | undefined) =>
  `${capital(reading)}. No other reading fits${next === undefined ? "" : `; the next is ${next} off`}.`;
export const several = (count: number) =>
  `${count} readings fit, and these numbers do not tell them apart. Three different angles do, such as 30 20 10.`;
export const severalOf = (count: number) => `${count} readings fit equally well.`;
export const none = (angle: string) => `No reading fits: the nearest is ${angle} off.`;

const units: Record<AngleUnit, string> = { degrees: "degrees", radians: "radians" };
const axesOf = (axes: readonly Axis[]) => axes.join(", ");

export const spokenProblem = ({ field, message, expected, hint }: Problem) =>
  `Problem in ${field === "numbers" ? numbers : attitude}: ${message}. Expected: ${expected}. Try: ${hint}.`;

/** What the numbers are, read so. */
export function readingWords(reading: Reading): string {
  const { meaning, direction } = reading;
  const isInverse = direction === "world-to-body";
  switch (meaning.kind) {
    case "euler-angles": {
      const { sequence, unit, turnsAbout } = meaning;
      const order =
        turnsAbout.join("") === sequence.axes ? "" : `, printed as ${axesOf(turnsAbout)}`;
      return `Euler angles ${sequenceWords(sequence)}${order}, in ${units[unit]}${conjugate(isInverse)}`;
    }
    case "rotation-vector":
      return `a rotation vector in ${units[meaning.unit]}${conjugate(isInverse)}`;
    case "half-angle-vector":
      return `a half-angle vector, angle/2 times the axis, in ${units[meaning.unit]}${conjugate(isInverse)}`;
    case "gibbs-vector":
      return `a Gibbs vector, tan(angle/2) times the axis${conjugate(isInverse)}`;
    case "modified-rodrigues":
      return `modified Rodrigues parameters, tan(angle/4) times the axis${conjugate(isInverse)}`;
    case "quaternion":
      return `the ${isInverse ? "conjugate" : "quaternion"}, ${lettersOf[meaning.order]}${axesWords(reading)}`;
    case "matrix": {
      const scale = Number(meaning.scale.toPrecision(4));
      const times = scale === 1 ? "" : `, times ${scale}`;
      return `${isInverse ? "the transposed matrix" : "the matrix"}${times}${axesWords(reading)}`;
    }
  }
}

/** `ZYX about the moving axes`: capitals as in Read. */
function sequenceWords({ axes, frame }: EulerSequence): string {
  if (frame === "intrinsic") return `${axes.toUpperCase()} about the moving axes`;
  return `${axes} about the fixed axes${axes === "xyz" ? " (roll, pitch, yaw)" : ""}`;
}

const conjugate = (isInverse: boolean) => (isInverse ? ", of the inverse attitude" : "");

/** On which axes it is: renamed, turned, or of the other handedness. */
function axesWords({ world, body }: Reading): string {
  if (world !== undefined && world.axes === body?.axes) {
    return `, with ${renamed(world)} in the world and the body${turned(world)}`;
  }
  const sides = [
    world && `${renamed(world)} in the world${turned(world)}`,
    body && `${renamed(body)} in the body${turned(body)}`,
  ].filter((side) => side !== undefined);
  return sides.length === 0 ? "" : `, with ${listed(sides)}`;
}

/** `y flipped`, or the new axes in terms of the old. */
function renamed({ axes }: OtherAxes): string {
  const signed = axes.split(" ");
  const letters = ["x", "y", "z"];
  const flipped = letters.filter((axis, at) => signed[at] === `-${axis}`);
  const keepsPlaces = letters.every((axis, at) => signed[at]?.endsWith(axis));
  return keepsPlaces ? `${listed(flipped)} flipped` : `the axes ${axes.replaceAll("-", "−")}`;
}

const turned = ({ factor }: OtherAxes) => (factor === undefined ? "" : ` (${turn(factor)})`);

/** `180° about x` of `180deg about [1, 0, 0]`. */
function turn(factor: string): string {
  const named = { "[1, 0, 0]": "x", "[0, 1, 0]": "y", "[0, 0, 1]": "z" };
  const [angle = "", axis = ""] = factor.split("deg about ");
  const name = Object.entries(named).find(([vector]) => vector === axis)?.[1] ?? axis;
  return `${angle}° about ${name.replaceAll("-", "−")}`;
}
