// What an end without a quaternion writes: its angles, its vector, its matrix.
import type { EndNumbers } from "../../engine.ts";
import type { Digits } from "../../model/page_state.ts";
import { exactArray, shown } from "../../number/format.ts";
import { numbersWords } from "../../words/library_behaviour.ts";
import { Copy } from "../parts/Copy.tsx";
import { Matrix } from "../parts/Value.tsx";

export function NumbersStrip({
  name,
  numbers,
  digits,
}: {
  /** What the end is called. */
  name: string;
  numbers: EndNumbers;
  digits: Digits;
}) {
  const { kind, unit, values } = numbers;
  const of = `${numbersWords(numbers)}: ${name}`;
  if (kind === "matrix") {
    const rows = [0, 3, 6].map((start) => values.slice(start, start + 3));
    return <Matrix name={of} symbol={numbersWords(numbers)} rows={rows} digits={digits} />;
  }
  return (
    <div class="strip">
      <span class="numbers-unit">{unit}</span>
      <dl class={`digits-${digits}`}>
        {namedNumbers(numbers).map(({ name, value }) => (
          <div key={name}>
            <dt>{name}</dt>
            <dd>{shown(value, digits)}</dd>
          </div>
        ))}
      </dl>
      <Copy of={of} text={exactArray(values)} />
    </div>
  );
}

/** Each number with its name, or else its place. */
export function namedNumbers({ names = "", values }: EndNumbers) {
  const called = names.split(" ");
  return values.map((value, at) => ({ name: called[at] || `${at + 1}`, value }));
}
