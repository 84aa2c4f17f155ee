// The words of the Identify view around its parts, and what a screen reader hears of it.
import type { Contradiction, Problem } from "../../engine.ts";
import { numbered } from "../phrases.ts";
import { left } from "./answer.tsx";
import { aboutOf } from "./choices.ts";

export const input = "Input";
export const none = "No answer yet.";
export const lead =
  "Which convention does this library use? Three short lines of code are usually enough to tell.";
export const start = "Start with an empty sheet";
export const library = "Library";
export const code = "Code in";
export const examples = "Examples";

/** What libraries print, one example of each surprise. */
export const exampleNames = {
  "not-jpl": "ij = −k and yet not JPL",
  stored: "Hamilton, stored x y z w",
  rounded: "Rounded, and −q",
  formal: "A formal sign",
  contradiction: "A contradiction",
};

export const matrices = "Which convention does a library of matrices use?";

export const seeAnswer = "See the answer";

/** Where the library has no name yet. */
export const unnamed = "The library";

/** What a screen reader hears when the result changes. */
export const spokenUnexplained = (at: number) => `Observation ${at + 1}: no behaviour prints this.`;

export const spokenProblem = (at: number, { message, expected, hint }: Problem) =>
  `Problem in observation ${at + 1}: ${message}. Expected: ${expected}. Try: ${hint}.`;

export const spokenContradiction = ({ observations, about }: Contradiction) =>
  `Observations ${numbered(observations)} contradict each other.${
    about.length > 0 ? ` They disagree about ${aboutOf(about)}.` : ""
  }`;

export const spokenAnswer = (possible: number, sentence: string) =>
  `${left(possible)}. ${sentence}`;
