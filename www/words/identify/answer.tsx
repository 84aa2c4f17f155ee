// What is said of the library that is asked about.
import { numbered } from "../phrases.ts";
import { allBehaviours } from "./choices.ts";

export const left = (possible: number) =>
  `${possible} of ${allBehaviours} behaviours ${possible === 1 ? "is" : "are"} left`;

export const copied = "the sentence for an issue";
export const fromBeforeContradiction =
  "Showing the last valid result, from before the contradiction.";

export const fromBeforeChange = (places: readonly number[]) =>
  `Showing the last valid result, from before the change of ${theObservations(places)}.`;

export const ofOthers = "Showing what the other observations say.";

export const uncounted = (places: readonly number[]) =>
  `Not counted: ${theObservations(places)}, which ${places.length === 1 ? "tells" : "tell"} nothing yet.`;

/** The ways on: the library, one that does the same, or the convention alone. */
export const translateFrom = (library: string) => `Translate from ${library}`;
export const translateAs = (library: string) => `Translate as ${library}`;
export const translateFromConvention = "Translate from this convention";

export const choices = (
  <>
    <span class="visually-hidden">The eight choices and the values that are left. </span>
    <var>R</var>(<var>q</var>) is Hamilton's matrix, and <var>C</var>(<var>q</var>) its transpose.
  </>
);

export const ofLibrary = "What it does";
export const ofUse = "How it is used";
export const settled = (count: number, all: number) => `${count} of ${all} settled`;

/** Said before a value. */
export const standing = { settled: "settled: ", open: "possible: ", out: "ruled out: " };

function theObservations(places: readonly number[]): string {
  return `observation${places.length === 1 ? "" : "s"} ${numbered(places)}`;
}
