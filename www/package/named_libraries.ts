// The ids of libraries as conventions, for numbers.
import type { Convention } from "../../pkg/quatlas.js";
import { libraryOf } from "./core.ts";
import { QuatlasError } from "./quatlas_error.ts";

/** The convention of what a library stores; a `QuatlasError` for an id that no library has. */
export function conventionOfLibrary(id: string): Convention {
  const found = libraryOf(id);
  if (found !== undefined) return found.convention;
  const hint = "look for its id in `libraries`";
  throw new QuatlasError("unknown-library", `no library has the id "${id}"`, hint);
}
