// How a product at one end is written at the other.
import { toFragment } from "../../address/fragment.ts";
import type { Engine, TranslatedEnd, TranslateReport } from "../../engine.ts";
import type { Store } from "../../state/store.ts";
import * as words from "../../words/translate/product_card.tsx";
import type { EndNames } from "../../words/translate/translate.ts";
import { libraryWith } from "../parts/library.ts";
import "../parts/result.css";
import "./product_card.css";

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
      <h2 id="product-name">{words.title}</h2>
      {isKnown && (
        <p class="fact-value product-line">
          <code>{productOf(from, engine)}</code>
          <span class="product-becomes">{words.becomes}</span>
          <code>
            {product === "reversed" ? swapped(productOf(to, engine)) : productOf(to, engine)}
          </code>
        </p>
      )}
      <p>
        {isKnown && words.operands(from, to, names, product)}
        {product === "neither" && words.neither}
        {product === "not-established" &&
          words.unknown(`#${toFragment({ ...store.state.value, view: "identify" })}`)}
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
