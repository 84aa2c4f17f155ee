// A turned pose as text for the field; pure.
import type { Digits } from "../model/page_state.ts";
import type { Quaternion } from "./space.ts";

/** Of a double, what is not rounding of a few products. */
const mostDecimals = 14;

/**
 * `45deg about z`, `57.2958deg about 0.6 0 0.8`: the turn that carries the world axes onto the body axes,
 * which is the same in every convention. Whatever its digits, its quaternion has norm 1, as four
 * rounded numbers seldom have. The angle has two decimals less than are shown, which is as fine.
 */
export function poseAsText({ w, x, y, z }: Quaternion, digits: Digits): string {
  const length = Math.hypot(x, y, z);
  // Of the two quaternions of a pose, the one with the shorter turn. Where there is none, some axis.
  const scale = (w < 0 ? -1 : 1) / length;
  const axis = length === 0 ? [0, 0, 1] : [x * scale, y * scale, z * scale];
  const angleDeg = (2 * Math.atan2(length, Math.abs(w)) * 180) / Math.PI;
  const decimals = digits === "all" ? mostDecimals : Number(digits);
  return `${rounded(angleDeg, decimals - 2)}deg about ${axisAsText(axis, decimals)}`;
}

const letters: Record<string, string> = {
  "1 0 0": "x",
  "0 1 0": "y",
  "0 0 1": "z",
  "-1 0 0": "-x",
  "0 -1 0": "-y",
  "0 0 -1": "-z",
};

function axisAsText(axis: readonly number[], decimals: number): string {
  const numbers = axis.map((part) => rounded(part, decimals)).join(" ");
  return letters[numbers] ?? numbers;
}

/** Without zeros at the end; adding 0 makes no −0. */
const rounded = (number: number, decimals: number) => String(Number(number.toFixed(decimals)) + 0);
