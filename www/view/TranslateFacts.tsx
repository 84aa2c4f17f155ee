// What else a translation changes: the product, the mistakes, the axes.
import { type Digits, toFragment } from "../address.ts";
import type { AxesReport, Engine, MappedAxes, TranslatedEnd, TranslateReport } from "../engine.ts";
import { shownDegrees } from "../format.ts";
import type { Store } from "../state.ts";
import {
  axesCardWords,
  type EndNames,
  frameWords,
  mistakeOf,
  mistakesWords,
  productCardWords,
} from "../words/translate.tsx";
import { libraryWith } from "./library.ts";
import { Matrix } from "./Value.tsx";

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
      <h2 id="product-name">{productCardWords.title}</h2>
      {isKnown && (
        <p class="fact-value product-line">
          <code>{productOf(from, engine)}</code>
          <span class="product-becomes">{productCardWords.becomes}</span>
          <code>
            {product === "reversed" ? swapped(productOf(to, engine)) : productOf(to, engine)}
          </code>
        </p>
      )}
      <p>
        {isKnown && productCardWords.operands(from, to, names, product)}
        {product === "neither" && productCardWords.neither}
        {product === "not-established" &&
          productCardWords.unknown(`#${toFragment({ ...store.state.value, view: "identify" })}`)}
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
export function MistakesCard({ report, digits }: { report: TranslateReport; digits: Digits }) {
  const mistakes = report.mistakes.map(({ kind, angleDeg }) => ({
    words: mistakeOf(kind, report.change),
    angleDeg,
  }));
  return (
    <section class="fact mistakes" aria-labelledby="mistakes-name">
      <h2 id="mistakes-name">{mistakesWords.title}</h2>
      <ul>
        {mistakes.map(({ words, angleDeg }) => (
          <li key={words}>
            <span class="mistake-words">{words}</span>
            {angleDeg === 0 ? (
              <span class="mistake-none">{mistakesWords.none}</span>
            ) : (
              <>
                <span class="mistake-angle">
                  {mistakesWords.off(<code>{shownDegrees(angleDeg, digits)}</code>)}
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
        <h2 id="axes-name">{axesCardWords.title}</h2>
        <p class="effect">{axesCardWords.formula}</p>
      </header>
      <div class="matrices">
        <Mapped of="world" mapped={axes.world} digits={digits} />
        <Mapped of="body" mapped={axes.body} digits={digits} />
      </div>
      <p class="hand-words">
        {axes.world.text !== axes.body.text
          ? axesCardWords.different(axes.world.hand)
          : axesCardWords[axes.world.hand === "changed" ? "mirrored" : "kept"]}
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
      name={axesCardWords.matrix(of)}
      symbol={
        <>
          <var>A</var>
          <sub>{frameWords[of]}</sub>
        </>
      }
      caption={axesCardWords.caption(mapped)}
      rows={mapped.rows}
      digits={digits}
    />
  );
}
