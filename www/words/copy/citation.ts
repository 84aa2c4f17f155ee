// The sentence that cites a case.
import type { Convention } from "../../engine.ts";
import { lettersOf } from "../conventions.ts";

const directions: Record<Convention["direction"], string> = {
  "body-to-world": "body to world",
  "world-to-body": "world to body",
};

/** The parts of a citation. */
export const citeWords = {
  convention: ({ order, handedness, function: does, direction }: Convention) =>
    `${handedness === "right" ? "Hamilton" : "JPL"} (${lettersOf[order]}, ${
      does === "active" ? "active, " : ""
    }${directions[direction]})`,
  unitQuaternion: (numbers: string) => `Unit quaternion ${numbers}`,
  quaternion: (numbers: string, norm: string | undefined) =>
    `Quaternion ${numbers} of ${norm === undefined ? "a norm beyond the range of a double" : `norm ${norm}`}`,
  turn: (angle: string, axis: string) => `${angle} about ${axis}`,
  noTurn: "no rotation",
  read: (quaternion: string, convention: string, turn: string) =>
    `${quaternion}, ${convention}: ${turn}.`,
  compose: (p: string, sign: string, q: string, product: string, convention: string) =>
    `${p} ${sign} ${q} = ${product}, ${convention}: the right one acts first.`,
  translate: (quaternion: string, from: string, to: string, becomes: string, turn: string) =>
    `${quaternion} of ${from} is ${becomes} in ${to}: ${turn}.`,
  source: (sentence: string, version: string, link: string) =>
    `${sentence} quatlas ${version}, ${link}`,
};
