// The names of the sequences of Euler angles.
import type { EulerSequence } from "../engine.ts";

/** `ZYX` about the moving axes, `zyx` about the fixed ones, as SciPy writes them. */
export function sequenceName({ axes: letters, frame }: EulerSequence): string {
  return frame === "intrinsic" ? letters.toUpperCase() : letters;
}
