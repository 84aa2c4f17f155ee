// The words of the picture.
import type { Reading } from "../model/picture_state.ts";

export const pictureWords = {
  role: "picture that can be turned",
  reading: "What moves",
  readings: {
    passive: { name: "Passive", meaning: "the axes move" },
    active: { name: "Active", meaning: "the vector moves" },
  } satisfies Record<Reading, { name: string; meaning: string }>,
  both: (other: string) => `Also as ${other}`,
  save: "Save SVG",
  reset: "First view",
  hands: "Drag to look round; drag the body to turn it.",
  keys: "Arrow keys look round, with Shift they turn the body; Page Up and Page Down roll it.",
  lookOnly: "Drag or use the arrow keys to look round.",
  inWords: "In words",
  fileName: "quatlas-rotation.svg",
};

export const readPictureLabel = "Picture of the rotation";

export const noTurnName = "no rotation";

export const noTurnWords = "No rotation: the body axes B stand on the world axes W.";

/** What the passive picture shows: two frames and one vector. */
export function passiveWords(turn: string, hasVector: boolean): string {
  const axes = `A rotation by ${turn} carries the world axes W onto the body axes B.`;
  return hasVector ? `${axes} The vector v stays; only its coordinates change.` : axes;
}

/** What the active picture shows: one frame and a vector before and after. */
export function activeWords(turn: string, matrix: string, hasVector: boolean): string {
  return hasVector
    ? `The axes stay: ${matrix} turns v into v′, and the body with it, by ${turn}.`
    : `The axes stay: ${matrix} turns the body by ${turn}.`;
}

/** The same in few words, where the turn stands beside them. */
export const inShort = {
  passive: (hasVector: boolean) =>
    `The rotation carries the axes W onto the axes B.${hasVector ? " v stays, only its coordinates change." : ""}`,
  active: (matrix: string, hasVector: boolean) =>
    `The axes stay: ${matrix} turns ${hasVector ? "v into v′, and the body with it" : "the body"}.`,
};

export const turnWords = (angle: string, axis: string) => `${angle} about ${axis}`;

/** Where the body axes point, for those who do not see them. */
export function axesWords(ends: readonly [string, string, string]): string {
  const [x, y, z] = ends;
  return `In world coordinates, the body's x axis points to ${x}, its y axis to ${y} and its z axis to ${z}.`;
}

/** The same where the body is turned and the axes stay. */
export function turnedAxesWords(ends: readonly [string, string, string]): string {
  const [x, y, z] = ends;
  return `The body is turned with it: what was along x now points to ${x}, along y to ${y} and along z to ${z}.`;
}

export const vectorWords = {
  passive: (world: string, body: string) =>
    `The vector v is ${world} on the world axes and ${body} on the body axes.`,
  active: (before: string, after: string) => `The vector v = ${before} becomes v′ = ${after}.`,
};

/** The second pose: the same numbers under the other product, in the declared direction. */
export function otherPoseWords(other: string, direction: string): string {
  return `Dashed: the same four numbers read as ${other}, ${direction}: the opposite rotation.`;
}

export function samePoseWords(other: string, direction: string): string {
  return `Read as ${other}, ${direction}, these four numbers are the same pose.`;
}

/** The steps of a composition. */
export const stepWords = {
  name: "Step by step",
  steps: ["Start", "First rotation", "Both rotations"],
  play: "Play",
  about: {
    fixed: (first: string, then: string) => `About fixed axes: first ${first}, then ${then}`,
    moving: (first: string, then: string) => `About moving axes: first ${first}, then ${then}`,
  },
  start: "The body stands on the world axes.",
  turned: {
    fixed: (operand: string, angle: string, axis: string) =>
      `${operand}: ${angle} about ${axis} of the world.`,
    moving: (operand: string, angle: string, axis: string) =>
      `${operand}: ${angle} about ${axis} of the body.`,
  },
  noTurn: (operand: string) => `${operand} is no rotation.`,
  end: (product: string) => `Both ways end in the same pose, that of ${product}.`,
  label: {
    fixed: "Picture of the rotations about fixed axes",
    moving: "Picture of the rotations about moving axes",
  },
  fileName: { fixed: "quatlas-fixed-axes.svg", moving: "quatlas-moving-axes.svg" },
};
