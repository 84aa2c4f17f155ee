// How the text of an operand was read.
import type { ComposeReport, Operand } from "../../engine.ts";
import { NamedComponents } from "../parts/ReadAs.tsx";
import type { ShownAs } from "./Formula.tsx";

export const operands: readonly Operand[] = ["p", "q"];

export function ReadOperand({
  operand,
  report,
  digits,
  unit,
}: Pick<ShownAs, "digits" | "unit"> & { operand: Operand; report: ComposeReport }) {
  return (
    <p>
      <var>{operand}</var>{" "}
      <NamedComponents quaternion={report[operand]} digits={digits} unit={unit} />
    </p>
  );
}
