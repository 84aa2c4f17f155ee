// A product of any number of factors, each as it is or inverted, in both notations; and their mean.
import { columnValues, quaternionValue } from "../../copy/values.ts";
import type { ChainReport, Request } from "../../engine.ts";
import { declaredConvention } from "../../model/conventions.ts";
import type { PageState, Preset } from "../../model/page_state.ts";
import type { Store } from "../../state/store.ts";
import * as words from "../../words/compose/chain.tsx";
import { arrowOf, wordsOf } from "../../words/conventions.ts";
import { AskedText, useAsked } from "../parts/asked.tsx";
import { Notes } from "../parts/Notes.tsx";
import { ArrayRow, Matrix } from "../parts/Value.tsx";
import { type Factor, factorsOf, factorsText, isReversed, mostFactors } from "./factors.ts";
import { TurnRows } from "./ProductForms.tsx";
import "./chain.css";

export { DeclaredForms, SwappedForms } from "./ProductForms.tsx";

export function askedOfChain(state: PageState): Request {
  const { matrix, euler } = state;
  const factors = factorsOf(state);
  if (isReversed(state)) factors.reverse();
  return { view: "chain", factors, convention: declaredConvention(state), matrix, euler };
}

/** In either order of components, and one that shows how another is typed. */
const noTurn = "w=1 x=0 y=0 z=0";

export function Chain({ store }: { store: Store }) {
  const { report, problems, old } = useAsked(store, askedOfChain, "chain");
  const factors = factorsOf(store.state.value);
  const inReverse = isReversed(store.state.value);
  const placeOf = (at: number) => (inReverse ? factors.length - 1 - at : at);
  const write = (next: readonly Factor[], as?: string) =>
    store.set({ factors: factorsText(next, inReverse) }, as === undefined ? {} : { as });
  const change = (at: number, part: Partial<Factor>, as?: string) =>
    write(
      factors.map((factor, place) => (place === at ? { ...factor, ...part } : factor)),
      as,
    );
  return (
    <section class="card asked" aria-label={words.title}>
      <ol class="chain-factors">
        {factors.map(({ text, inverse }, at) => (
          <li key={at}>
            {at < 2 ? (
              <FactorName at={at} />
            ) : (
              <AskedText
                label={words.factor(at + 1)}
                symbol={<FactorName at={at} />}
                text={text}
                problem={problems.find((problem) => problem.at === placeOf(at))}
                onInput={(text) => change(at, { text }, `factor ${at}`)}
              />
            )}
            <label>
              <input
                type="checkbox"
                checked={inverse}
                aria-label={words.inverts(at + 1)}
                onChange={({ currentTarget }) => change(at, { inverse: currentTarget.checked })}
              />{" "}
              {words.inverse}
            </label>
            {at >= 2 && (
              <button
                type="button"
                class="quiet"
                aria-label={words.removes(at + 1)}
                onClick={() => write(factors.filter((_, place) => place !== at))}
              >
                {words.remove}
              </button>
            )}
          </li>
        ))}
        <li>
          {factors.length < mostFactors && (
            <button
              type="button"
              class="quiet"
              onClick={() => write([...factors, { text: noTurn, inverse: false }])}
            >
              {words.add}
            </button>
          )}
          <label>
            <input
              type="checkbox"
              checked={inReverse}
              onChange={() => store.set({ factors: factorsText(factors, !inReverse) })}
            />{" "}
            {words.reverse}
          </label>
        </li>
      </ol>
      {report && (
        <div class={`asked ${old}`}>
          <Notes
            notes={report.notes.filter((_, at) => placeOf(report.noted[at] ?? 0) >= 2)}
            store={store}
          />
          <Product store={store} report={report} factors={factors} inReverse={inReverse} />
        </div>
      )}
    </section>
  );
}

/** p, q, and the others by their place. */
function FactorName({ at }: { at: number }) {
  if (at < 2) return <var>{at === 0 ? "p" : "q"}</var>;
  return (
    <>
      <var>r</var>
      <sub>{at - 1}</sub>
    </>
  );
}

interface Multiplied {
  store: Store;
  report: ChainReport;
  /** As they are listed. */
  factors: readonly Factor[];
  inReverse: boolean;
}

function Product({ store, report, factors, inReverse }: Multiplied) {
  const { digits } = store.state.value;
  const { mean, declared } = report;
  return (
    <>
      <div class="asked-columns">
        {(["hamilton", "jpl"] as const).map((preset) => (
          <InNotation key={preset} {...{ store, report, factors, inReverse, preset }} />
        ))}
      </div>
      <div>
        <TurnRows store={store} report={report} />
        {mean ? (
          <ArrayRow
            name={words.mean}
            symbol={words.mean}
            numbers={mean.array}
            digits={digits}
            value={quaternionValue("q", mean, declared.convention, store.engine.describe)}
          />
        ) : (
          <p class="asked-lead">{words.noMean}</p>
        )}
      </div>
    </>
  );
}

/** The product as one of the conventions writes it, with the factors in its order. */
function InNotation({
  store,
  report,
  factors,
  inReverse,
  preset,
}: Multiplied & { preset: Preset }) {
  const { digits } = store.state.value;
  const column = report[preset];
  const { name, order, matrix } = wordsOf[preset];
  const values = columnValues(column, store.engine.describe);
  const written = factors.map(({ inverse }, at) => (
    <span key={at}>
      <FactorName at={at} />
      {inverse && <sup>−1</sup>}
    </span>
  ));
  const isListed = column.rules.operator === report.declared.rules.operator;
  if (isListed === inReverse) written.reverse();
  const sign = preset === "hamilton" ? " ⊙ " : " ⊗ ";
  const product = written.flatMap((factor, at) => (at === 0 ? [factor] : [sign, factor]));
  return (
    <div class={preset}>
      <h3>
        {name} <span class="chain-product">{product}</span>
      </h3>
      <ArrayRow
        name={words.productIn(name)}
        symbol={words.product}
        numbers={column.quaternion.array}
        digits={digits}
        note={order}
        value={values.quaternion}
      />
      <ArrayRow
        name={words.inverseIn(name)}
        symbol={words.itsInverse}
        numbers={column.inverse?.array}
        digits={digits}
        value={values.inverse}
      />
      <Matrix
        name={words.matrixIn(matrix)}
        symbol={<var>{matrix}</var>}
        caption={arrowOf(column.rules.operator)}
        rows={column.matrix}
        digits={digits}
        value={values.matrix}
      />
    </div>
  );
}
