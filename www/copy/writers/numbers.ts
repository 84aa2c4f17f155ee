// Numbers in code: the shortest text that reads back as the same double, and never -0.
import { arrayOf, namesOf } from "../../model/component_order.ts";
import type { CopiedQuaternion } from "../../model/copied.ts";

/** As JavaScript, MATLAB and JSON write it: whole numbers stay short. */
export function plain(number: number): string {
  return String(number + 0);
}

/** With a point or an exponent, where a whole number would be an integer. */
export function float(number: number): string {
  const text = plain(number);
  return /[.e]/.test(text) ? text : `${text}.0`;
}

/** With a power of ten as it is printed. */
export function printed(number: number): string {
  const [mantissa = "", exponent] = plain(number).split("e");
  return exponent === undefined
    ? mantissa
    : `${mantissa} \\times 10^{${exponent.replace("+", "")}}`;
}

export function listed(
  numbers: readonly number[],
  written: (number: number) => string,
  mark = ", ",
): string {
  return numbers.map(written).join(mark);
}

/**
 * Four numbers in the order of their convention, under a name that tells it: programs of every
 * language read four bare numbers in either order.
 */
export function ordered({ components, convention }: CopiedQuaternion): {
  name: string;
  numbers: number[];
} {
  const { order } = convention;
  return { name: `q_${namesOf[order].join("")}`, numbers: arrayOf(components, order) };
}

/** The turns of a sequence in the order of the factors: the one that acts last stands first. */
export function factors<Angle>(
  axes: string,
  frame: "intrinsic" | "extrinsic",
  angles: readonly Angle[],
): { axis: string; angle: Angle }[] {
  const turns = angles.map((angle, at) => ({ axis: axes[at] ?? "", angle }));
  return frame === "intrinsic" ? turns : turns.reverse();
}

const units: Record<string, readonly number[]> = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] };

export const unitOf = (axis: string): readonly number[] => units[axis] ?? [];
