// The words of one end of a translation.
import type { ComponentChildren } from "preact";
import type { Assumption, Direction, Side } from "../../engine.ts";
import type { EndMatrix } from "../../model/copied.ts";
import { notEstablished, takesWords } from "../library_behaviour.ts";

export const product = `product ${notEstablished}`;

export const takes = (action: ComponentChildren, direction: Direction) => (
  <>
    {action} takes {takesWords[direction]}.
  </>
);

export const axes = (text: string) => `Axes: ${text}.`;
export const doubt = "Not certain:";

export const itTakes = (direction: Direction) => `It takes ${takesWords[direction]}.`;

export const assumptions = {
  order: "Assumed: the order of its numbers is not established, and is taken as x y z w.",
  action: "Assumed: what it does to a vector is not established, and is taken as R(q).",
} satisfies Record<Assumption, string>;

export const code = "code";
export const copiedLine = (name: string) => `the line of code of ${name}`;
export const copiedCall = (name: string) => `the call of ${name}`;
export const matrix = (name: string) => `matrix of ${name}`;
export const matrixOf = {
  "as-printed": "as printed, ",
  "of-unit": "of q/|q|, ",
} satisfies Record<EndMatrix, string>;
export const noMatrix = `What it prints as the matrix is ${notEstablished}.`;
export const constructed = (name: string) => `q of ${name} as its constructor takes it`;
export const constructedNote = "as its constructor takes them";

export const first = {
  right: "acts on a vector first by b, then by a",
  left: "acts on a vector first by a, then by b",
} satisfies Record<Side, string>;

export const noFirst = `which of the two acts first is ${notEstablished}`;
export const called = "is called";
export const noFamily = `its product is ${notEstablished}`;
export const nonUnit = "norm not 1";
export const noNonUnit = `what it makes of it is ${notEstablished}`;
