// The Compose view: two quaternions, both products, both orders.
import { productValues } from "../../copy/values.ts";
import type { ComposeReport, Engine, Frame, Handedness, Operand, Product } from "../../engine.ts";
import { presetOf } from "../../model/conventions.ts";
import type { Digits } from "../../model/page_state.ts";
import { shownArray } from "../../number/format.ts";
import type { Store } from "../../state/store.ts";
import * as words from "../../words/compose/compose.tsx";
import { arrowOf, wordsOf } from "../../words/conventions.ts";
import { AskRest } from "../parts/Ask.tsx";
import { ConventionSwitch } from "../parts/ConventionSwitch.tsx";
import { nameOf } from "../parts/convention_names.ts";
import { Notes } from "../parts/Notes.tsx";
import { Picture } from "../parts/Picture.tsx";
import { NamedComponents } from "../parts/ReadAs.tsx";
import { TextField } from "../parts/TextField.tsx";
import { UndoRedo } from "../parts/UndoRedo.tsx";
import { ComponentStrip, Matrix } from "../parts/Value.tsx";
import "../parts/result.css";
import "./compose.css";

export function Compose({ store }: { store: Store }) {
  const { digits, unit } = store.state.value;
  const shownResult = store.compose.value;
  return (
    <>
      <section class="ask" aria-label={words.input}>
        <div class="ask-row">
          <div class="ask-pair">
            <TextField store={store} field="p" />
            <TextField store={store} field="q" />
          </div>
          <ConventionSwitch store={store} />
          <UndoRedo store={store} />
        </div>
        <AskRest store={store} freshness={shownResult?.freshness}>
          {shownResult && (
            <div class="read-as">
              <p>
                <var>p</var>{" "}
                <NamedComponents quaternion={shownResult.report.p} digits={digits} unit={unit} />
              </p>
              <p>
                <var>q</var>{" "}
                <NamedComponents quaternion={shownResult.report.q} digits={digits} unit={unit} />
              </p>
              <Notes notes={shownResult.report.notes} store={store} />
            </div>
          )}
        </AskRest>
      </section>
      {shownResult && (
        <div class={`result ${shownResult.freshness}`}>
          <Result report={shownResult.report} store={store} />
        </div>
      )}
    </>
  );
}

const signOf: Record<Handedness, string> = { right: "⊙", left: "⊗" };
const letterOf: Record<Frame, string> = { world: "W", body: "B", "second-body": "B′" };
const otherOf: Record<Operand, Operand> = { p: "q", q: "p" };

function Result({ report, store }: { report: ComposeReport; store: Store }) {
  const { digits } = store.state.value;
  const { declared } = report;
  // Each product of the Hamilton kind stands beside the JPL product that has the same numbers.
  const pairs = report.products
    .filter((product) => product.convention.handedness === "right")
    .flatMap((hamilton) => {
      const jpl = report.products.find(
        ({ convention, left }) => convention.handedness === "left" && left === hamilton.right,
      );
      return jpl ? [{ hamilton, jpl }] : [];
    });
  // First the pair that is the same attitude as the product as declared.
  if (declared.direction === "world-to-body") pairs.reverse();
  return (
    <>
      <Road report={report} engine={store.engine} digits={digits} />
      <Picture store={store} of="compose" />
      {pairs.map(({ hamilton, jpl }) => (
        <section
          key={hamilton.left}
          class="pair"
          aria-label={words.equals(spelled(hamilton), spelled(jpl))}
        >
          <h2 class="tie">
            <span class="hamilton">
              <Formula product={hamilton} />
            </span>{" "}
            <span class="tie-sign">=</span>{" "}
            <span class="jpl">
              <Formula product={jpl} />
            </span>
            <span class="tie-words">{words.tie}</span>
          </h2>
          <div class="columns">
            <ProductCard product={hamilton} engine={store.engine} digits={digits} />
            <ProductCard product={jpl} engine={store.engine} digits={digits} />
          </div>
        </section>
      ))}
    </>
  );
}

function spelled({ left, right, convention }: Product): string {
  return `${left} ${signOf[convention.handedness]} ${right}`;
}

/** The letters of the frames on the way of a vector. */
function framesOf({ frames: [start, middle, end] }: Product): [string, string, string] {
  return [letterOf[start], letterOf[middle], letterOf[end]];
}

function Formula({ product }: { product: Product }) {
  return (
    <>
      <var>{product.left}</var> {signOf[product.convention.handedness]} <var>{product.right}</var>
    </>
  );
}

/** The product as declared, as the way of a vector through the frames. */
function Road({
  report,
  engine,
  digits,
}: {
  report: ComposeReport;
  engine: Engine;
  digits: Digits;
}) {
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
      {preset === undefined && (
        <ComponentStrip
          symbol={spelled(product)}
          name={words.declared(spelled(product))}
          components={product.quaternion}
          convention={product.convention}
          value={productValues(product, engine.describe).quaternion}
          digits={digits}
        />
      )}
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

function ProductCard({
  product,
  engine,
  digits,
}: {
  product: Product;
  engine: Engine;
  digits: Digits;
}) {
  const preset = presetOf[product.convention.handedness];
  const own = wordsOf[preset];
  const [start, middle, end] = framesOf(product);
  const first = product.firstAboutFixedAxes;
  const values = productValues(product, engine.describe);
  return (
    <section class={`card column ${preset}`} aria-label={`${own.name}: ${spelled(product)}`}>
      <header>
        <h3>
          {own.name} <Formula product={product} />
        </h3>
        <p class="axes">
          <span>
            {start} → {middle} → {end}
          </span>{" "}
          <span>{words.firstThen(<var>{product.right}</var>, <var>{product.left}</var>)}</span>
        </p>
      </header>
      <ComponentStrip
        symbol={spelled(product)}
        name={`${own.name} ${spelled(product)}`}
        components={product.quaternion}
        convention={product.convention}
        value={values.quaternion}
        digits={digits}
      />
      <div class="matrices">
        <Matrix
          name={`${own.matrix}(${spelled(product)})`}
          symbol={
            <>
              <var>{own.matrix}</var>(<Formula product={product} />) = <var>{own.matrix}</var>(
              <var>{product.left}</var>) <var>{own.matrix}</var>(<var>{product.right}</var>)
            </>
          }
          caption={`${start} → ${end}`}
          rows={product.matrix}
          value={values.matrix}
          digits={digits}
        />
      </div>
      <p class="turns">{words.turns(<var>{first}</var>, <var>{otherOf[first]}</var>)}</p>
    </section>
  );
}
