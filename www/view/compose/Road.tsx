// The way of a vector through the frames, by the product as declared.
import type { ComposeReport } from "../../engine.ts";
import { shownArray } from "../../number/format.ts";
import * as words from "../../words/compose/compose.tsx";
import { arrowOf, wordsOf } from "../../words/conventions.ts";
import { nameOf } from "../parts/convention_names.ts";
import { Formula, framesOf, type ShownAs } from "./Formula.tsx";
import { operands, ReadOperand } from "./ReadOperand.tsx";

/** The product as declared, as the way of a vector through the frames. */
export function Road({
  report,
  engine,
  digits,
  unit,
}: Omit<ShownAs, "declared"> & { report: ComposeReport }) {
  const product = report.declared;
  const [start, middle, end] = framesOf(product);
  const { preset } = engine.describe(product.convention);
  const name = preset ? wordsOf[preset].name : nameOf(product.convention, engine);
  const [afterRight, afterBoth] = product.images ?? [];
  const right = <var>{product.right}</var>;
  const left = <var>{product.left}</var>;
  return (
    <section class={`card road ${preset ?? "custom"}`} aria-labelledby="road-name">
      <h2 id="road-name">
        <Formula product={product} />: {words.firstThen(right, left)}
      </h2>
      <ol class="road-steps">
        <li>
          <span class="road-frame">{words.onAxes(<var>v</var>, start)}</span>
          <code>{shownArray(report.vector, digits)}</code>
        </li>
        <li>
          <span class="road-frame">{words.afterOnAxes(right, middle)}</span>
          <code>{afterRight ? shownArray(afterRight, digits) : words.beyond}</code>
        </li>
        <li>
          <span class="road-frame">{words.afterOnAxes(left, end)}</span>
          <code>{afterBoth ? shownArray(afterBoth, digits) : words.beyond}</code>
        </li>
      </ol>
      <p>
        {words.meet(
          name ?? words.yours,
          words.matricesDo[product.convention.function](arrowOf(product.direction)),
          [right, left],
          [start, middle, end],
        )}
      </p>
      <OrderWords report={report} />
      {/* Where the numbers of the product come first; elsewhere this stands under the fields. */}
      <div class="road-operands">
        {operands.map((operand) => (
          <ReadOperand
            key={operand}
            operand={operand}
            report={report}
            digits={digits}
            unit={unit}
          />
        ))}
      </div>
    </section>
  );
}

function OrderWords({ report }: { report: ComposeReport }) {
  switch (report.orderMatters) {
    case "yes":
      return null;
    case "no":
      return <p class="order-words">{words.commute}</p>;
    case "only-in-sign":
      return <p class="order-words">{words.anticommute}</p>;
  }
}
