// The formats of a copy, and which kinds of values each can say; the writers are loaded when needed.
import type { Copied, Kind } from "./copied.ts";

const rotations: Kind[] = ["quaternion", "matrix", "axis-angle", "rotation-vector", "euler"];
const all: Kind[] = [...rotations, "vector"];

const rounding = 1e-9;

/** New axes may be a reflection, and a product matrix, a derivative or a covariance is no rotation. */
function isRotation(value: Copied): boolean {
  if (value.kind !== "matrix") return true;
  const entries = value.rows.flat();
  const [[a = 0, b = 0, c = 0] = [], [d = 0, e = 0, f = 0] = [], [g = 0, h = 0, i = 0] = []] =
    value.rows;
  const determinant = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g);
  // Lengths whose product is 1 and whose squares have the sum 3 are 1 each.
  const off = Math.abs(determinant - 1) + Math.abs(Math.hypot(...entries) ** 2 - 3);
  return entries.length === 9 && off < rounding;
}

/** In the order of the menu. */
export const formats = [
  { id: "numbers", kinds: all },
  { id: "eigen", kinds: all },
  { id: "scipy", kinds: rotations },
  { id: "numpy", kinds: all },
  { id: "ros", kinds: ["quaternion", "vector"] },
  { id: "nalgebra", kinds: all },
  { id: "javascript", kinds: all },
  { id: "three", kinds: all },
  { id: "matlab", kinds: all },
  { id: "latex", kinds: all },
  { id: "json", kinds: all },
  { id: "test-vector", kinds: all },
] as const satisfies readonly { id: string; kinds: readonly Kind[] }[];

export type Format = (typeof formats)[number]["id"];
/** What is written by a writer; numbers are text already. */
export type CodeFormat = Exclude<Format, "numbers">;

/** The sequences that three.js has: three different axes. */
const isThreeDifferent = (axes: string) => new Set(axes).size === 3;

/** Whether a value can be said in a format. */
export function canSay(format: Format, value: Copied): boolean {
  const kinds: readonly Kind[] = formats.find(({ id }) => id === format)?.kinds ?? [];
  if (!kinds.includes(value.kind)) return false;
  if (format === "scipy") return isRotation(value);
  if (value.kind === "matrix") {
    const [rows, columns = 0] = [value.rows.length, value.rows[0]?.length];
    // These have no type for a larger one, nor three.js for one that is not square.
    if (format === "three") return rows === columns && rows < 5;
    if (format === "nalgebra") return Math.max(rows, columns) < 7;
  }
  if (format === "ros" && value.kind === "vector") return value.numbers.length === 3;
  if (format === "three" && value.kind === "euler") return isThreeDifferent(value.sequence.axes);
  return true;
}
