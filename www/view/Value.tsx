// Numbers on the page: components by name, matrices with brackets, rows.
import type { ComponentChildren } from "preact";
import type { Digits } from "../address.ts";
import type { Copied } from "../copy/copied.ts";
import type { Components, Convention } from "../engine.ts";
import { alignedRows, exactArray, exactRows, shown, shownArray } from "../format.ts";
import { Copy } from "./Copy.tsx";

/** The four components in the order of the convention, each under its name. */
export function ComponentStrip({
  name,
  symbol,
  components,
  convention,
  digits,
  value,
}: {
  /** For the copy button. */
  name: string;
  symbol: string;
  components: Components;
  convention: Pick<Convention, "order">;
  digits: Digits;
  value?: Copied | undefined;
}) {
  const names = namesInOrder(convention);
  return (
    <div class="strip">
      <var>{symbol}</var>
      <dl>
        {names.map((name, at) => (
          <div key={name} class={name === "w" ? "strip-scalar" : undefined}>
            <dt>{name}</dt>
            <dd>{shown(components.array[at] ?? 0, digits)}</dd>
          </div>
        ))}
      </dl>
      <Copy of={name} text={exactArray(components.array)} value={value} />
    </div>
  );
}

export function namesInOrder(convention: Pick<Convention, "order">): ("w" | "x" | "y" | "z")[] {
  return convention.order === "scalar-first" ? ["w", "x", "y", "z"] : ["x", "y", "z", "w"];
}

/** On a phone, and with all digits, a matrix can be wider than its place. */
const mayScroll = (digits: Digits) => digits === "all" || matchMedia("(width < 30rem)").matches;

/** A matrix with brackets and aligned decimals, under its name and what it does. */
export function Matrix({
  name,
  symbol,
  caption,
  rows,
  digits,
  value,
}: {
  /** For the copy button and for screen readers. */
  name: string;
  symbol: ComponentChildren;
  caption?: string;
  rows: readonly (readonly number[])[];
  digits: Digits;
  value?: Copied | undefined;
}) {
  return (
    <figure class="matrix">
      <figcaption>
        <span class="matrix-symbol">{symbol}</span>
        {caption !== undefined && <span class="matrix-caption">{caption}</span>}
        <Copy of={name} text={exactRows(rows)} value={value} />
      </figcaption>
      {/* Where it is wider than its place, the arrow keys reach all of it. */}
      <section
        class={`matrix-scroll digits-${digits}`}
        aria-label={`${name}, row by row`}
        {...(mayScroll(digits) ? { tabIndex: 0 } : {})}
      >
        <table aria-label={name}>
          <tbody>
            {alignedRows(rows, digits).map((row, at) => (
              <tr key={at}>
                {row.map((cell, column) => (
                  <td key={column}>{cell}</td>
                ))}
              </tr>
            ))}
          </tbody>
        </table>
      </section>
    </figure>
  );
}

/** A named row with an array: `R(q) x   [0, 1, 0]`. */
export function ArrayRow({
  name,
  symbol,
  numbers,
  digits,
  note,
  value,
}: {
  name: string;
  symbol: ComponentChildren;
  numbers: readonly number[] | undefined;
  digits: Digits;
  note?: ComponentChildren;
  value?: Copied | undefined;
}) {
  return (
    <div class="row">
      <span class="row-symbol">{symbol}</span>
      <span class="row-value">
        {numbers === undefined ? (
          <span class="row-absent">beyond the range of a double</span>
        ) : (
          <code>{shownArray(numbers, digits)}</code>
        )}
        {note !== undefined && <span class="row-note">{note}</span>}
      </span>
      {numbers !== undefined && <Copy of={name} text={exactArray(numbers)} value={value} />}
    </div>
  );
}
