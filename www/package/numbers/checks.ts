// What is given, looked at before it is computed with.
import { QuatlasError } from "../quatlas_error.ts";

/** Numbers in a row, as arrays or as typed arrays have them. */
export type Numbers = readonly number[] | Float64Array | Float32Array;

/** Three numbers. */
export type Vector3 = [x: number, y: number, z: number];

/** Four numbers; in which order tells their convention. */
export type Quaternion4 = [number, number, number, number];

/** Nine numbers, row by row. */
export type Rows3 = [Vector3, Vector3, Vector3];

/** The value, which has to be so many finite numbers; `what` it is goes into the error. */
export function checkNumbers(value: unknown, count: number, what: string, row?: number): Numbers {
  const details = row === undefined ? {} : { row };
  if (!isList(value)) {
    const hint = `give an array or a Float64Array of ${count} numbers`;
    throw new QuatlasError("wrong-type", `${what} is ${kindOf(value)}`, hint, details);
  }
  if (value.length !== count) {
    const isGone = value instanceof Float64Array && value.length === 0;
    const hint = isGone
      ? "its buffer may have been given to a worker; give numbers that are still there"
      : `it needs ${count}`;
    const message = `${what} has ${value.length} numbers`;
    throw new QuatlasError("wrong-count", message, hint, details);
  }
  for (let at = 0; at < count; at += 1) {
    if (!Number.isFinite(value[at])) throw notFinite(value[at], `${what}[${at}]`, details);
  }
  return value;
}

/** Nine numbers, one row after the other, of a matrix that is given as its three rows. */
export function checkRows(value: unknown): number[] {
  if (!Array.isArray(value) || value.length !== 3) {
    const isFlat = isList(value) && value.length === 9;
    const given = isFlat ? "one list of 9 numbers" : kindOf(value);
    const hint = isFlat
      ? "give three rows; three.js, gl-matrix and MATLAB store columns in such a list, NumPy rows"
      : "give three rows of three numbers";
    throw new QuatlasError("wrong-count", `the matrix is ${given}`, hint);
  }
  return value.flatMap((row, at) => [...checkNumbers(row, 3, `row ${at} of the matrix`, at)]);
}

/** The value, which has to be a finite number. */
export function checkNumber(value: unknown, what: string): number {
  if (typeof value !== "number" || !Number.isFinite(value)) throw notFinite(value, what, {});
  return value;
}

/** The place of a word in a list of choices. */
export function placeOf(value: unknown, choices: readonly string[], what: string): number {
  const place = choices.indexOf(value as string);
  if (place >= 0) return place;
  const names = choices.map((choice) => `"${choice}"`).join(" or ");
  const given = typeof value === "string" ? `"${value}"` : kindOf(value);
  throw new QuatlasError("unknown-choice", `${what} is ${given}`, `write ${names}`);
}

/** What a value is, in words. */
export function kindOf(value: unknown): string {
  if (value === null) return "null";
  if (Array.isArray(value)) return "an array";
  if (typeof value === "undefined") return "missing";
  if (typeof value === "number") return `the number ${value}`;
  return typeof value === "object" ? "an object" : `a ${typeof value}`;
}

function isList(value: unknown): value is Numbers {
  return Array.isArray(value) || value instanceof Float64Array || value instanceof Float32Array;
}

function notFinite(value: unknown, what: string, details: { row?: number }): QuatlasError {
  const code = typeof value === "number" ? "not-finite" : "wrong-type";
  return new QuatlasError(code, `${what} is ${kindOf(value)}`, "give a finite number", details);
}
