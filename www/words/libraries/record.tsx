// The words of one record of the table.
import type { Code } from "../../engine.ts";

export const title = (name: string) => `The record of ${name}`;
export const from = "Translate from";
export const to = "Translate to";
export const link = "link to this record";
export const copiedLink = "the link to this record";
export const means = "What it means";
export const doubt = "Not certain:";
export const kind = "Record of a";
export const writes = "Writes";
export const order = "Order";
export const written = (names: string | undefined, unit: string, means: string) => (
  <>
    {names ?? "a b c"}
    {unit}: <code>{means}</code>
  </>
);

export const printsAndStores = (printed: string, stored: string) =>
  `prints ${printed}, stores ${stored}`;
export const called = "Called";
export const direction = "Direction";

export const takes = (action: string, coordinates: string) =>
  `${action}(q) takes ${coordinates}, as documented`;

export const leads = (coordinates: string) => `takes ${coordinates}`;
export const axes = "Axes";
export const euler = "Euler angles";

export const eulerCall = (call: string, means: string) => (
  <>
    <code>{call}</code> is <code>{means}</code>
  </>
);

export const axisAngle = "+θ about z";
export const ofMatrix = "Of a matrix";
export const slerp = "slerp";
export const nonUnit = "Norm 2";
export const zero = "Zero";
export const known = "How it is known";
export const calls = "Calls";
export const source = "Source";

export const code = {
  construct: "construct",
  rotate: "rotate v",
  matrix: "matrix",
  product: "product",
  fromMatrix: "of a matrix",
  print: "print",
} satisfies Record<keyof Code, string>;

export const copiedCall = (name: string) => `the call: ${name}`;
