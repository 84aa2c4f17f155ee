// The sentences about how the readings of Hamilton and JPL relate, and about the order of products.
import type { ComponentChildren } from "preact";
import type { Preset } from "../../model/page_state.ts";

export const title = "How the two readings relate";
export const sameNumbers = "Same numbers, transposed matrices.";

export const sameNumbersSays = (
  <>
    Hamilton goes body → world, JPL world → body: one attitude,{" "}
    <strong>nothing is conjugated</strong>, only reordered.
  </>
);

export const sameMatrix = "Same matrix, conjugate numbers.";

/** The JPL numbers whose matrix is that of the Hamilton column. */
export const sameMatrixSays = (numbers: ComponentChildren) => (
  <>
    Only if the JPL side states body → world (Yoosefian 2021, eq. 18): <var>q</var> = {numbers}.
  </>
);

/** Whether the first applies to what was declared. */
export const applies = (declared: Preset | undefined) => {
  if (declared === undefined) return "Applies between programs that keep these customs.";
  return declared === "hamilton"
    ? "Applies if the JPL side keeps its custom."
    : "Applies if the Hamilton side keeps its custom.";
};

export const declared = "This is what you declared.";

export const declaredNot = "Not what you declared.";

export const order = "Composition order.";

const label = (frames: string) => (
  <>
    <var>q</var>
    <sub>{frames}</sub>
  </>
);

export const orderSays = (
  <>
    In <var>p</var>∘<var>q</var>, <var>q</var> acts first, in both. A camera C on body B:{" "}
    {label("WB")} ⊙ {label("BC")}, in JPL {label("BC")} ⊗ {label("WB")}.
  </>
);
