// Numbers for reading and for copying; pure.
import type { Digits, Unit } from "../model/page_state.ts";

const minus = "−";
/** Below this a fixed number of decimals would hide the digits. */
const smallestFixed = 1e-4;
const largestFixed = 1e6;

/** What differs by so much less than the largest number beside it is rounding, not information. */
const roundingNoise = 1e-14;

/**
 * A number for reading: rounded as chosen, with a true minus sign; whole numbers stay short.
 * `largest` is the largest size among the numbers that stand beside it.
 */
export function shown(number: number, digits: Digits, largest = 0): string {
  return written(number, digits, largest).replace("e+", "e").replaceAll("-", minus);
}

function written(number: number, digits: Digits, largest: number): string {
  if (digits === "all") return exact(number);
  const size = Math.abs(number);
  if (Number.isInteger(number) && size < largestFixed) return exact(number);
  // A cosine of 90 degrees beside a 0 is no other kind of zero.
  const whole = Math.round(number);
  if (size < largestFixed && Math.abs(number - whole) < roundingNoise * largest) {
    return exact(whole + 0);
  }
  const decimals = Number(digits);
  if (size < smallestFixed || size >= largestFixed) return exponential(number, decimals);
  return number.toFixed(decimals);
}

function largestOf(numbers: readonly number[]): number {
  return Math.max(0, ...numbers.map(Math.abs));
}

function exponential(number: number, decimals: number): string {
  return number
    .toExponential(decimals)
    .replace(/\.?0+e/, "e")
    .replace("e+", "e");
}

/** The shortest text that reads back as the same double. */
export function exact(number: number): string {
  return String(number);
}

/** `[0.5, 0, -1]`, exact. */
export function exactArray(numbers: readonly number[]): string {
  return `[${numbers.map(exact).join(", ")}]`;
}

/** `[[…], […]]`, row by row, exact. */
export function exactRows(rows: readonly (readonly number[])[]): string {
  return `[${rows.map(exactArray).join(", ")}]`;
}

/** `[0.5, 0, −1]` for reading. */
export function shownArray(numbers: readonly number[], digits: Digits): string {
  const largest = largestOf(numbers);
  return `[${numbers.map((number) => shown(number, digits, largest)).join(", ")}]`;
}

/**
 * Cells of a matrix, padded so that the decimal points of each column stand below each other: with the
 * plain space, which every font has as wide as a digit if its digits are all of one width.
 */
export function alignedRows(rows: readonly (readonly number[])[], digits: Digits): string[][] {
  const largest = largestOf(rows.flat());
  const cells = rows.map((row) =>
    row.map((number) => splitAtPoint(shown(number, digits, largest))),
  );
  const widths = (part: 0 | 1, column: number) =>
    Math.max(...cells.map((row) => row[column]?.[part].length ?? 0));
  return cells.map((row) =>
    row.map(
      ([whole, fraction], column) =>
        whole.padStart(widths(0, column)) + fraction.padEnd(widths(1, column)),
    ),
  );
}

/** Cells of a matrix of so many columns, all columns padded to the same width. */
export function alignedAll(
  numbers: readonly number[],
  columns: number,
  digits: Digits,
): string[][] {
  const cells = alignedRows(
    numbers.map((number) => [number]),
    digits,
  ).flat();
  return Array.from({ length: cells.length / columns }, (_, row) =>
    cells.slice(row * columns, (row + 1) * columns),
  );
}

function splitAtPoint(text: string): [string, string] {
  const at = text.search(/[.e]/);
  return at < 0 ? [text, ""] : [text.slice(0, at), text.slice(at)];
}

/** An angle in both units, each as exactly as it is known. */
export interface Angle {
  degrees: number;
  radians: number;
}

/** What a conversion can lose is not shown. */
const convertedDigits = 15;

/** Degrees without the digits that their making from radians cannot tell: 45, not 45.00000000000001. */
export const inDegrees = (degrees: number) => Number(degrees.toPrecision(convertedDigits));

export function fromDegrees(degrees: number): Angle {
  return { degrees, radians: Number(((degrees * Math.PI) / 180).toPrecision(convertedDigits)) };
}

export function fromRadians(radians: number): Angle {
  return { degrees: Number(((radians * 180) / Math.PI).toPrecision(convertedDigits)), radians };
}

/** `45°`, `53.130102°` or `0.785398 rad` for reading. */
export function shownAngle(angle: Angle, digits: Digits, unit: Unit): string {
  return unit === "degrees"
    ? `${shown(inDegrees(angle.degrees), digits)}°`
    : `${shown(angle.radians, digits)}\u00a0rad`;
}

/** `53.1°` or `0.927 rad`: an angle in a sentence, of which few digits matter. */
export function shownRoughAngle(degrees: number, unit: Unit, significantDigits = 3): string {
  const angle = fromDegrees(degrees);
  const rough = Number(angle[unit].toPrecision(significantDigits));
  return shownAngle({ ...angle, [unit]: rough }, "all", unit);
}

const axisNames: [string, readonly number[]][] = [
  ["x", [1, 0, 0]],
  ["y", [0, 1, 0]],
  ["z", [0, 0, 1]],
  ["−x", [-1, 0, 0]],
  ["−y", [0, -1, 0]],
  ["−z", [0, 0, -1]],
];

/** `z`, `−x` or `[0.57735, …]`. */
export function shownAxis(axis: readonly number[], digits: Digits): string {
  const named = axisNames.find(([, unit]) => unit.every((number, at) => number === axis[at]));
  return named?.[0] ?? shownArray(axis, digits);
}

/** A norm that differs from 1 by more than rounding is said, and not taken for that of a unit quaternion. */
const roundingOfNorm = 1e-14;

export const isNormOne = (norm: number | undefined) =>
  norm !== undefined && Math.abs(norm - 1) <= roundingOfNorm;
