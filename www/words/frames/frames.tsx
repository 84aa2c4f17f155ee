// The words of the Frames view.
import type { Problem } from "../../engine.ts";
import { problemWords } from "../parts/notes.tsx";

export const input = "Input";
export const question = "Where is";
export const inWord = "in";
export const point = "Point";
export const pointIn = (frame: string) => `a point in ${frame}`;
export const known = "What is known";
export const say =
  "Each row says where a frame stands in another: “I1 in G” takes coordinates in I1 to coordinates in G.";
export const columns = {
  child: "Frame",
  parent: "In",
  rotation: "Rotation, or a 4×4 matrix",
  position: "Position",
  convention: "Four numbers as",
} as const;
export const ofRow = (at: number, what: string) => `Row ${at + 1}: ${what}`;
export const conventionNames = { "": "as declared", hamilton: "Hamilton", jpl: "JPL" } as const;
export const add = "Add a row";
export const remove = (at: number) => `Remove row ${at + 1}`;
export const examples = "Examples:";
export const exampleNames = {
  rig: "Yoosefian’s rig",
  jpl: "Three quaternions of a JPL filter",
  cameras: "Two cameras of a calibration",
  loop: "A loop that does not close",
};
export const askedChild = "The frame that is asked about";
export const askedParent = "The frame in which it is asked for";

export const problemOf = ({ message, expected, hint }: Problem) => (
  <>
    <bdi>{message}</bdi>. <span class="problem-key">{problemWords.expected}</span> {expected}.{" "}
    <span class="problem-key">{problemWords.try}</span> {hint}.
  </>
);
export const fixWords = {
  rename: (name: string, old?: string) => (old ? `Call ${old} ${name}` : `Write ${name}`),
  add: (child: string, parent: string) => `Add a row: ${child} in ${parent}`,
};
export const unreadRows = (rows: readonly number[]) =>
  `${rows.length > 1 ? "Rows" : "Row"} ${rows.join(", ")} cannot be read: see there.`;
export const noAnswer = "There is no answer yet: see above.";

export const title = (child: string, parent: string) => `${child} in ${parent}`;
export const position = "position";
export const at = "at";
export const noPosition = "A row on the way has no position, so only the rotation is known.";
export const turn = (angle: string, axis: string) => `turned by ${angle} about ${axis}`;
export const noTurn = "not turned";
export const quaternionOf = (name: string) => `q as ${name}`;
export const wayName = "The way";
export const row = (at: number) => `row ${at + 1}`;
export const inverted = (at: number) => `row ${at + 1}, inverted`;
export const orderIs = {
  hamilton:
    "Hamilton, body to world: from left to right as the way goes; an inverted row is conjugated.",
  jpl: "JPL, world to body: the same numbers in reverse order.",
};
export const pointsName = "The point in every frame";
export const closesName = "Rows that have to agree";
export const loop = (at: number, angle: string, distance: string | undefined, way: string) =>
  `Row ${at + 1} against the way ${way}: ${angle}${distance === undefined ? "" : ` and ${distance}`} apart.`;
export const agrees = (at: number, way: string) => `Row ${at + 1} agrees with the way ${way}.`;
export const inverseCloses = (at: number) =>
  `With row ${at + 1} the other way round they agree: are its frames exchanged?`;
export const transposeCloses = (at: number) =>
  `With the inverse rotation in row ${at + 1} they agree: is it of another convention?`;
export const mistakeName = "What goes wrong";
export const mistake =
  "The position of an inverted row is turned back too. Only subtracted, as Yoosefian 2021 prints the last term of the position, it gives";
export const off = (distance: string) => `, ${distance} off.`;
export const more = "Matrices and angles";
export const homogeneous = "Homogeneous matrix";
export const takes = (child: string, parent: string) => `${child} → ${parent}`;
export const euler = "Euler angles";
export const misprinted = "position as it is printed";

/** What copied numbers say they are, without names that somebody typed: it goes into source files. */
export const copies = {
  position: "origin of the frame that is asked about, in coordinates of the other",
  point: "coordinates of the point in one frame",
  homogeneous: "takes x y z 1 of the frame that is asked about to those of the other",
  inverse: "takes x y z 1 of the other frame to those of the one that is asked about",
};

export const spoken = (title: string, turn: string, position: string) =>
  `Result: ${title}: ${turn}${position}.`;
export const spokenPosition = (position: string) => `, at ${position}`;
