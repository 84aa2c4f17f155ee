// What a change of axes does.
import type { MappedAxes } from "../../engine.ts";

/** A side of a change of axes. */
export const frameWords = { world: "world", body: "body" } as const;

export const title = "The change of axes";

export const formula = (
  <>
    The new matrix is <var>A</var>
    <sub>{frameWords.world}</sub> <var>R</var> <var>A</var>
    <sub>{frameWords.body}</sub>
    <sup>T</sup>, with <var>R</var> from body to world.
  </>
);

export const matrix = (of: keyof typeof frameWords) => `new axes of the ${frameWords[of]}`;

export const caption = ({ text, determinant }: MappedAxes) =>
  `new x y z = ${text.replaceAll("-", "−")}, determinant ${determinant > 0 ? "+1" : "−1"}`;

/** World and body change differently, and the handedness is kept or changed. */
export const different = (hand: MappedAxes["hand"]) =>
  `World and body change differently, so the rotation from one to the other changes${
    hand === "changed" ? ", and so does the handedness of both" : ""
  }. Determinants of different sign would make a reflection, which has no quaternion.`;

export const mirrored = (
  <>
    <strong>Both change the handedness of the axes</strong>: right-handed ones become left-handed,
    or the reverse. The rotation in space stays the same, but its sign is now that of the other
    hand: counter-clockwise about an axis becomes clockwise. So the rotation vector becomes −
    <var>A</var> times the old one, not <var>A</var> times. One side alone would be a reflection,
    which has no quaternion.
  </>
);

export const kept =
  "Both keep the handedness of the axes (determinant +1): counter-clockwise about an axis stays counter-clockwise.";
