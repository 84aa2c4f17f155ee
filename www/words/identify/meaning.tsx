// What follows from the choices, and what numbers cannot tell.
import { listed } from "../phrases.ts";

export const relatives = "Between Hamilton and JPL";
export const product = "product";
export const rotates = "rotates a column by";
export const actsFirst = "acts first in a * b";
export const operand = { left: "a, the left", right: "b, the right" };
export const open = "open";
export const familyOpen = "Open until the product and the rotation are settled.";

export const first = (operand: string) => (
  <>
    In <code>a * b</code> <strong>{operand}</strong> acts first on a vector.
  </>
);

export const firstOpen =
  "Which operand acts first follows from the product and the rotation: still open.";

export const takes = (coordinates: string) => (
  <>
    For the attitude of a body the call that rotates takes <strong>{coordinates}</strong>.
  </>
);

export const takesOpen =
  "Which coordinates to which it takes depends on how an attitude is written: a body turned by 90° tells.";

/** What adding a small rotation φ does to the body. */
export const smallTurn = (axes: string, turn: string) => (
  <>
    A small rotation <var>φ</var> about the axes of <strong>{axes}</strong> turns the body by{" "}
    <strong>{turn}</strong>.
  </>
);

export const smallTurnOpen =
  "The axes and the sign of a small rotation show only with a body turned by 90°.";

export const columns = (
  <>
    Its matrix multiplies <strong>column vectors</strong> as the call that rotates does.
  </>
);

export const rows = (
  <>
    Its matrix is the transpose of what rotates: it is for <strong>row vectors</strong>, v&nbsp;M,
    or it is the inverse.
  </>
);

export const unsettled = "What no numbers tell";

export const labels =
  "A function and a direction reversed together leave every number as it is. Which of the two labels is meant, only the documentation says.";

export const label = (name: string, direction: string, effect: string) =>
  `${name}, ${direction} (${effect})`;
export const either = (labels: readonly string[]) => listed(labels, "or");
