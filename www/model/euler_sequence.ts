// The sequences of Euler angles and their names.
import type { EulerAxes, EulerSequence } from "../engine.ts";

/** The twelve sequences: three different axes, then those that end as they begin. */
export const eulerAxes = [
  ...["xyz", "xzy", "yxz", "yzx", "zxy", "zyx"],
  ...["xyx", "xzx", "yxy", "yzy", "zxz", "zyz"],
] as EulerAxes[];

/** `ZYX` about the moving axes, `zyx` about the fixed ones, as SciPy writes them. */
export function sequenceName({ axes: letters, frame }: EulerSequence): string {
  return frame === "intrinsic" ? letters.toUpperCase() : letters;
}
