// What else a translation changes: the product, the mistakes, the axes.

import { toFragment } from "../../address/fragment.ts";
import { newAxesValue } from "../../copy/values.ts";
import type {
  AxesReport,
  Engine,
  MappedAxes,
  TranslatedEnd,
  TranslateReport,
} from "../../engine.ts";
import type { Digits, Unit } from "../../model/page_state.ts";
import { fromDegrees, shownAngle } from "../../number/format.ts";
import type { Store } from "../../state/store.ts";
import * as axesWords from "../../words/translate/axes_card.tsx";
import * as mistakeWords from "../../words/translate/mistakes_card.tsx";
import * as productWords from "../../words/translate/product_card.tsx";
import type { EndNames } from "../../words/translate/translate.ts";
import { libraryWith } from "../parts/library.ts";
import { Matrix } from "../parts/Value.tsx";
import "../parts/result.css";
import "./facts.css";

/** How `a * b` of the first end is written at the second. */
export function ProductCard({
  report,
  names,
  store,
}: {
  report: TranslateReport;
  names: EndNames;
  store: Store;
}) {
  const { engine } = store;
  const { from, to, product } = report;
  const isKnown = product === "same" || product === "reversed";
  return (
    <section class="fact" aria-labelledby="product-name">
      <h2 id="product-name">{productWords.title}</h2>
      {isKnown && (
        <p class="fact-value product-line">
          <code>{productOf(from, engine)}</code>
          <span class="product-becomes">{productWords.becomes}</span>
          <code>
            {product === "reversed" ? swapped(productOf(to, engine)) : productOf(to, engine)}
          </code>
        </p>
      )}
      <p>
        {isKnown && productWords.operands(from, to, names, product)}
        {product === "neither" && productWords.neither}
        {product === "not-established" &&
          productWords.unknown(`#${toFragment({ ...store.state.value, view: "identify" })}`)}
      </p>
    </section>
  );
}

function productOf(end: TranslatedEnd, engine: Engine): string {
  return libraryWith(engine, end.library)?.code?.product ?? "a * b";
}

/** The call with its operands in each other's place. */
const swapped = (call: string) =>
  call.replace(/\b[ab](?=\b|0\b|vec\b)/g, (operand) => (operand === "a" ? "b" : "a"));

/** The angle by which the attitude is wrong. */
export function MistakesCard({
  report,
  digits,
  unit,
}: {
  report: TranslateReport;
  digits: Digits;
  unit: Unit;
}) {
  const mistakes = report.mistakes.map(({ kind, angleDeg }) => ({
    words: mistakeWords.mistakeOf(kind, report.change),
    angleDeg,
  }));
  return (
    <section class="fact mistakes" aria-labelledby="mistakes-name">
      <h2 id="mistakes-name">{mistakeWords.title}</h2>
      <ul>
        {mistakes.map(({ words, angleDeg }) => (
          <li key={words}>
            <span class="mistake-words">{words}</span>
            {angleDeg === 0 ? (
              <span class="mistake-none">{mistakeWords.none}</span>
            ) : (
              <>
                <span class="mistake-angle">
                  {mistakeWords.off(<code>{shownAngle(fromDegrees(angleDeg), digits, unit)}</code>)}
                </span>
                <span class="mistake-bar" aria-hidden="true">
                  <span style={{ width: `${(angleDeg / 180) * 100}%` }} />
                </span>
              </>
            )}
          </li>
        ))}
      </ul>
    </section>
  );
}

/** The change of axes, with its matrices. */
export function AxesCard({ axes, digits }: { axes: AxesReport; digits: Digits }) {
  return (
    <section class="card column custom" aria-labelledby="axes-name">
      <header>
        <h2 id="axes-name">{axesWords.title}</h2>
        <p class="effect">{axesWords.formula}</p>
      </header>
      <div class="matrices">
        <Mapped of="world" mapped={axes.world} digits={digits} />
        <Mapped of="body" mapped={axes.body} digits={digits} />
      </div>
      <p class="hand-words">
        {axes.world.text !== axes.body.text
          ? axesWords.different(axes.world.hand)
          : axes.world.hand === "changed"
            ? axesWords.mirrored
            : axesWords.kept}
      </p>
    </section>
  );
}

function Mapped({
  of,
  mapped,
  digits,
}: {
  of: "world" | "body";
  mapped: MappedAxes;
  digits: Digits;
}) {
  return (
    <Matrix
      name={axesWords.matrix(of)}
      symbol={
        <>
          <var>A</var>
          <sub>{axesWords.frameWords[of]}</sub>
        </>
      }
      caption={axesWords.caption(mapped)}
      rows={mapped.rows}
      value={newAxesValue(of, mapped.rows, mapped.text)}
      digits={digits}
    />
  );
}
