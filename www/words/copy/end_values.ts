// What the copied values of a translation say they are; plain ASCII.
import type { PrintedMatrix } from "../../engine.ts";
import type { EndMatrix } from "../../model/copied.ts";

const multiplies: Record<PrintedMatrix["vectors"], string> = {
  column: "multiplies columns, M v",
  row: "multiplies rows, v M",
};

export const endWords = {
  endMatrix: {
    "as-printed": (name: string, { vectors }: PrintedMatrix) =>
      `as ${name} prints it; it ${multiplies[vectors]}`,
    "of-unit": (name: string, { form, vectors }: PrintedMatrix) =>
      `${form}(q/|q|) of the numbers of ${name}; it ${multiplies[vectors]}`,
  } satisfies Record<EndMatrix, unknown>,
  newAxes: (of: string, text: string) => `new axes of the ${of}: new x y z = ${text}`,
};
