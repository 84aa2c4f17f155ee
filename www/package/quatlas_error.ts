// What is thrown where numbers cannot be computed with.

/** What a `QuatlasError` tells by its `code`; none changes its meaning. */
export type ErrorCode =
  /** A value is of another kind than its parameter: a text for a number, an object that is no rotation. */
  | "wrong-type"
  /** A list has more or fewer numbers than it needs, or its buffer was given away to a worker. */
  | "wrong-count"
  /** A number is NaN or infinite. */
  | "not-finite"
  /** A quaternion of four zeros. */
  | "zero-quaternion"
  /** An axis, or a vector that gives a direction, of length zero. */
  | "zero-vector"
  /** Nine numbers that are no rotation matrix. */
  | "not-a-rotation"
  /** A matrix with a negative determinant: a mirror image. */
  | "reflection"
  /** Several attitudes are as good: the mean of two opposite ones, vectors along one line. */
  | "not-unique"
  /** The answer is larger than any double. */
  | "too-large"
  /** A word that names no choice: a direction, a unit, a side. */
  | "unknown-choice"
  /** Not three axes, or one that follows itself. */
  | "unknown-sequence"
  /** No convention: a member is missing, or has another value. */
  | "unknown-convention"
  /** An id that no library of the table has. */
  | "unknown-library"
  /** Two quaternions with two conventions. */
  | "mixed-conventions"
  /** The child of a pose is not the parent of the next. */
  | "frames-do-not-meet"
  /** `quatlas/web` was not yet loaded. */
  | "not-loaded"
  /** WebAssembly is not there, or the policy of the page forbids it. */
  | "no-wasm"
  /** A mistake in quatlas. */
  | "core-stopped";

/** What else an error may tell. */
export interface ErrorDetails {
  /** The place in a list that was given. */
  row?: number;
  cause?: unknown;
}

/**
 * Thrown for what cannot be computed with: it says what was given, and what would do.
 *
 * @example
 * // Four zeros are no attitude; dividing by their norm would give NaN.
 * const codeOf = (call) => { try { return call(); } catch (error) { return error.code; } };
 * codeOf(() => Rotation.fromQuat([0, 0, 0, 0], JPL)); // "zero-quaternion"
 */
export class QuatlasError extends Error {
  static {
    QuatlasError.prototype.name = "QuatlasError";
  }

  /** What is wrong, as a word that programs compare with. */
  readonly code: ErrorCode;
  /** What to do about it, in one sentence. */
  readonly hint: string;
  /** The place, from 0, in the list that was given; undefined where none was. */
  readonly row: number | undefined;

  constructor(code: ErrorCode, message: string, hint: string, details: ErrorDetails = {}) {
    super(`${message}: ${hint}`, details.cause === undefined ? {} : { cause: details.cause });
    this.code = code;
    this.hint = hint;
    this.row = details.row;
  }
}
