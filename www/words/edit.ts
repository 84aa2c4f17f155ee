// The words of editing: undo and redo, and what the fields of the result are called.
import type { PageState } from "../address.ts";

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

/** What stands under a number that cannot be read, while it is edited. */
export const numberProblem = (
  typed: string,
  { message, expected }: { message: string; expected: string },
) => (typed.trim() === "" ? "A number is missing here." : `${message}. Expected ${expected}.`);

export const fieldWords = {
  component: (group: string, name: string) => `${group}, ${name}`,
  entry: (matrix: string, row: number, column: number) => `${matrix}, row ${row}, column ${column}`,
  angleIn: (unit: string) => `angle in ${unit}`,
  axis: (name: string) => `axis, ${name}`,
  rotationVector: (name: string) => `rotation vector, ${name}`,
  eulerAngle: (name: string, unit: string) => `${name} in ${unit}`,
  degrees: "degrees",
  radians: "radians",
  about: "about",
} as const;
