// Numbers on the page: components by name, matrices with brackets, rows.
import type { ComponentChildren } from "preact";
import type { Components, Convention } from "../../engine.ts";
import { type ComponentName, namesOf } from "../../model/component_order.ts";
import type { Copied } from "../../model/copied.ts";
import type { Digits } from "../../model/page_state.ts";
import {
  alignedAll,
  alignedRows,
  exactArray,
  exactRows,
  shown,
  shownArray,
} from "../../number/format.ts";
import { fieldWords } from "../../words/parts/number_field.ts";
import { beyondDouble, rowByRow } from "../../words/parts/value.ts";
import { Copy, CopyLine } from "./Copy.tsx";
import { NumberField } from "./NumberField.tsx";
import { type Edited, numberGroup, shownNumbers } from "./number_group.ts";
import { SideScroll } from "./SideScroll.tsx";
import "./value.css";

/** The four components in the order of the convention, each under its name. */
export function ComponentStrip({
  name,
  symbol,
  components,
  convention,
  digits,
  edited,
  value,
  copied = "beside",
}: {
  /** For the copy button and the fields. */
  name: string;
  symbol: string;
  components: Components;
  convention: Pick<Convention, "order">;
  digits: Digits;
  /** Where the components can be edited. */
  edited?: Edited;
  value?: Copied | undefined;
  /** By a button beside them, or in a line below that shows what is copied. */
  copied?: "beside" | "below";
}) {
  const names = namesInOrder(convention);
  const group = edited && numberGroup(edited, components.array);
  const copy = { of: name, text: exactArray(components.array), value };
  const strip = (
    <div class="strip">
      <var>{symbol}</var>
      <dl class={`${group ? "edited " : ""}digits-${digits}`}>
        {names.map((component, at) => (
          <div key={component} class={component === "w" ? "strip-scalar" : undefined}>
            <dt>{component}</dt>
            <dd>
              {group ? (
                <NumberField
                  group={group}
                  at={at}
                  label={fieldWords.component(name, component)}
                  digits={digits}
                />
              ) : (
                shown(components.array[at] ?? 0, digits)
              )}
            </dd>
          </div>
        ))}
      </dl>
      {copied === "beside" && <Copy {...copy} />}
    </div>
  );
  if (copied === "beside") return strip;
  return (
    <div class="strip-and-line">
      {strip}
      <CopyLine {...copy} />
    </div>
  );
}

export function namesInOrder({ order }: Pick<Convention, "order">): readonly ComponentName[] {
  return namesOf[order];
}

/** A matrix with brackets and aligned decimals, under its name and what it does. */
export function Matrix({
  name,
  symbol,
  caption,
  rows,
  digits,
  edited,
  value,
}: {
  /** For the copy button and for screen readers. */
  name: string;
  symbol: ComponentChildren;
  caption?: string;
  rows: readonly (readonly number[])[];
  digits: Digits;
  /** Where the entries can be edited. */
  edited?: Edited;
  value?: Copied | undefined;
}) {
  const group = edited && numberGroup(edited, rows.flat());
  const cells = group ? alignedAll(shownNumbers(group), 3, digits) : alignedRows(rows, digits);
  return (
    <figure class={`matrix ${group ? "edited" : ""} ${digits === "all" ? "with-all" : ""}`}>
      <figcaption>
        <span class="matrix-symbol">{symbol}</span>
        {caption !== undefined && <span class="matrix-caption">{caption}</span>}
      </figcaption>
      <SideScroll name={rowByRow(name)} digits={digits}>
        {/* A table whose cells the arrow keys reach is a grid. */}
        <table aria-label={name} {...(group && { role: "grid" })}>
          <tbody>
            {cells.map((row, at) => (
              <tr key={at}>
                {row.map((cell, column) => (
                  <td key={column}>
                    {group ? (
                      <NumberField
                        group={group}
                        at={at * row.length + column}
                        label={fieldWords.entry(name, at + 1, column + 1)}
                        digits={digits}
                        text={cell}
                      />
                    ) : (
                      cell
                    )}
                  </td>
                ))}
              </tr>
            ))}
          </tbody>
        </table>
      </SideScroll>
      <Copy of={name} text={exactRows(rows)} value={value} />
    </figure>
  );
}

/** A named row with an array: `R(q) v   [0, 1, 0]`. */
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
          <span class="row-absent">{beyondDouble}</span>
        ) : (
          <code>{shownArray(numbers, digits)}</code>
        )}
        {note !== undefined && <span class="row-note">{note}</span>}
      </span>
      {numbers !== undefined && <Copy of={name} text={exactArray(numbers)} value={value} />}
    </div>
  );
}
