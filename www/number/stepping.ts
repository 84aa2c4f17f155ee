// A number that the arrow keys step up and down; pure.

/** How much larger or smaller a step is than the usual one. */
export type Stride = "usual" | "long" | "short";

const factors: Record<Stride, number> = { usual: 1, long: 10, short: 0.1 };

/** A double has no more decimals than these that can be relied on beside a number of size 1. */
const mostDecimals = 15;

/** The text of a number after one step; it keeps the decimals that it has. */
export function stepped(number: number, step: number, stride: Stride, direction: 1 | -1): string {
  const by = step * factors[stride];
  const next = number + direction * by;
  const decimals = Math.min(mostDecimals, Math.max(decimalsOf(number), decimalsOf(by)));
  // Adding 0 makes a zero of a negative one.
  const rounded = Number(next.toFixed(decimals)) + 0;
  return String(Number.isFinite(rounded) ? rounded : number);
}

function decimalsOf(number: number): number {
  const [, decimals = "", power = "0"] = /^[^.e]*\.?(\d*)(?:e(.+))?$/.exec(String(number)) ?? [];
  return Math.max(0, decimals.length - Number(power));
}
