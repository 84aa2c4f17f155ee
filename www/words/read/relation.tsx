// The two sentences about how the readings of Hamilton and JPL relate.
import type { Preset } from "../../model/page_state.ts";

export const title = "How the two readings relate";
export const sameNumbers = "Same numbers, transposed matrices";

export const sameNumbersSays = (
  <>
    <var>C</var>(<var>q</var>) = <var>R</var>(<var>q</var>)<sup>T</sup>. Hamilton leads from body to
    world and JPL from world to body, so both say the same attitude:{" "}
    <strong>nothing is conjugated</strong>, only the order of the numbers changes.
  </>
);

export const sameMatrix = "Same matrix, conjugate numbers";

export const sameMatrixSays = (
  <>
    If a JPL program states the direction body to world, its matrix <var>C</var> is this{" "}
    <var>R</var>(<var>q</var>), and its vector part has the <strong>other sign</strong>{" "}
    <span class="source">(Yoosefian 2021, eq. 18)</span>.
  </>
);

export const hamilton = "Hamilton, body → world";
export const jpl = "JPL, world → body";
export const jplBodyToWorld = "JPL, body → world";

/** Whether the first applies to what was declared. */
export const applies = (declared: Preset | undefined) => {
  if (declared === undefined) return "Applies between two programs that keep these customs.";
  return declared === "hamilton"
    ? "Applies to you if the JPL side keeps its custom, world to body."
    : "Applies to you if the Hamilton side keeps its custom, body to world.";
};

export const declared = "This is what you declared.";

/** Why the second is not what was declared. */
export const appliesNot = (declared: Preset | undefined) =>
  declared === "jpl"
    ? "Not what you declared: your JPL numbers lead from world to body."
    : "Not what you declared: only for a JPL side that states body to world.";
