// The words of undo and redo.
import type { PageState } from "../model/page_state.ts";

/** What a part of the state is called when it is undone. */
const partNames: Partial<Record<keyof PageState, string>> = {
  preset: "convention",
  axes: "convention",
  matrix: "matrix convention",
  euler: "Euler sequence",
  quaternion: "quaternion",
  p: "quaternion p",
  q: "quaternion q",
  vector: "vector",
  translated: "quaternion",
  from: "from",
  to: "to",
  worldAxes: "world axes",
  bodyAxes: "body axes",
  observations: "observations",
  libraryName: "library name",
  language: "language",
  unavailable: "probes left out",
  matrices: "matrices",
  within: "time",
  rate: "rate",
  rateEnd: "rate",
  covariance: "covariance",
  point: "point",
  motion: "choice",
  frames: "poses",
  find: "search",
  library: "library",
};

const namesOf = (parts: readonly (keyof PageState)[]) =>
  [...new Set(parts.map((part) => partNames[part] ?? part))].join(", ");

export const undoWords = {
  undo: "Undo",
  redo: "Redo",
  undone: (parts: readonly (keyof PageState)[]) => `Undone: ${namesOf(parts)}`,
  redone: (parts: readonly (keyof PageState)[]) => `Redone: ${namesOf(parts)}`,
} as const;
