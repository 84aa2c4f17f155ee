// The Compose view: two quaternions, both products, both orders.
import { type ComponentChildren, Fragment } from "preact";
import { productValues } from "../../copy/values.ts";
import type { ComposeReport, Engine, Frame, Handedness, Operand, Product } from "../../engine.ts";
import { presetOf } from "../../model/conventions.ts";
import type { Digits, Unit } from "../../model/page_state.ts";
import { shownAngle, shownArray, shownAxis } from "../../number/format.ts";
import type { Store } from "../../state/store.ts";
import * as words from "../../words/compose/compose.tsx";
import { arrowOf, asDeclared, wordsOf } from "../../words/conventions.ts";
import { AskRest } from "../parts/Ask.tsx";
import { CarryLinks } from "../parts/CarryLinks.tsx";
import { ConventionSwitch } from "../parts/ConventionSwitch.tsx";
import { nameOf } from "../parts/convention_names.ts";
import { Notes } from "../parts/Notes.tsx";
import { Picture } from "../parts/Picture.tsx";
import { NamedComponents } from "../parts/ReadAs.tsx";
import { TextField } from "../parts/TextField.tsx";
import { UndoRedo } from "../parts/UndoRedo.tsx";
import { ComponentStrip, Matrix } from "../parts/Value.tsx";
import "../parts/fold.css";
import "../parts/result.css";
import "./compose.css";

export { spokenProduct } from "./spoken.ts";

export function Compose({ store }: { store: Store }) {
  const { digits, unit } = store.state.value;
  const shownResult = store.compose.value;
  return (
    <>
      <section class="ask" aria-label={words.input}>
        <div class="ask-row">
          <div class="ask-pair">
            <TextField store={store} field="p" />
            <TextField store={store} field="q">
              <UndoRedo store={store} />
            </TextField>
          </div>
          <ConventionSwitch store={store} />
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
  const { digits, unit } = store.state.value;
  const { declared } = report;
  const isPreset = store.engine.describe(declared.convention).preset !== undefined;
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
  const [headline, ...others] = pairs.map(({ hamilton, jpl }) => ({
    key: hamilton.left,
    // First the product as declared.
    tied: declared.convention.handedness === "left" ? [jpl, hamilton] : [hamilton, jpl],
  }));
  const shownAs = { engine: store.engine, declared, digits, unit };
  return (
    <>
      {!isPreset && <ProductCard product={declared} {...shownAs} />}
      {headline && (
        <Pair tied={headline.tied} {...shownAs}>
          <CarryLinks
            store={store}
            of={spelled(declared)}
            quaternion={{ components: declared.quaternion, convention: declared.convention }}
            to={["read", "translate"]}
          />
        </Pair>
      )}
      <Road report={report} engine={store.engine} digits={digits} />
      <Picture store={store} of="compose" />
      {others.map(({ key, tied }) => (
        <details key={key} class="fold">
          <summary>{words.otherOrder(tied.map(spelled).join(" = "))}</summary>
          <Pair tied={tied} {...shownAs} />
        </details>
      ))}
    </>
  );
}

/** How the numbers of a product are shown. */
interface ShownAs {
  engine: Engine;
  /** The product that has the badge. */
  declared: Product;
  digits: Digits;
  unit: Unit;
}

/** Two products that have the same numbers. */
function Pair({
  tied,
  children,
  ...shownAs
}: ShownAs & { tied: readonly Product[]; children?: ComponentChildren }) {
  return (
    <section class="pair" aria-label={tied.map(spelled).join(` ${words.equals} `)}>
      <div class="pair-head">
        <h2 class="tie">
          {tied.map((product, at) => (
            <Fragment key={spelled(product)}>
              {at > 0 && <span class="tie-sign"> = </span>}
              <span class={presetOf[product.convention.handedness]}>
                <Formula product={product} />
              </span>
            </Fragment>
          ))}{" "}
          <span class="tie-words">{words.tie}</span>
        </h2>
        {children}
      </div>
      <div class="columns">
        {tied.map((product) => (
          <ProductCard key={spelled(product)} product={product} {...shownAs} />
        ))}
      </div>
    </section>
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

function ProductCard({ product, engine, declared, digits, unit }: ShownAs & { product: Product }) {
  const { preset } = engine.describe(product.convention);
  const { name, matrix } = preset
    ? wordsOf[preset]
    : { name: nameOf(product.convention, engine) ?? words.yours, matrix: undefined };
  const isDeclared =
    product.left === declared.left && preset === engine.describe(declared.convention).preset;
  const [start, middle, end] = framesOf(product);
  const first = product.firstAboutFixedAxes;
  const values = productValues(product, engine.describe);
  const { axis, angleDeg, angleRad } = product.turn;
  return (
    <section
      class={`card column ${preset ?? "custom"}`}
      aria-label={`${name}: ${spelled(product)}`}
    >
      <header>
        <h3>
          {name} <Formula product={product} />
        </h3>
        {isDeclared && <span class="badge">{asDeclared}</span>}
        <p class="effect">
          {words.firstThen(<var>{product.right}</var>, <var>{product.left}</var>)} · {start} →{" "}
          {middle} → {end}
        </p>
      </header>
      <ComponentStrip
        symbol={spelled(product)}
        name={preset ? `${name} ${spelled(product)}` : words.declared(spelled(product))}
        components={product.quaternion}
        convention={product.convention}
        value={values.quaternion}
        digits={digits}
        copied="below"
      />
      <div class="row product-turn">
        <span class="row-symbol">{words.rotation}</span>
        <span class="row-value">
          {axis === undefined ? (
            words.noRotation
          ) : (
            <code>
              {words.about(
                shownAngle({ degrees: angleDeg, radians: angleRad }, digits, unit),
                shownAxis(axis, digits),
              )}
            </code>
          )}
        </span>
      </div>
      {matrix !== undefined && (
        <>
          <Matrix
            name={`${matrix}(${spelled(product)})`}
            symbol={
              <>
                <var>{matrix}</var>(<Formula product={product} />)
              </>
            }
            caption={`${start} → ${end}`}
            rows={product.matrix}
            value={values.matrix}
            digits={digits}
          />
          <p class="turns">
            <var>{matrix}</var>(<Formula product={product} />) = <var>{matrix}</var>(
            <var>{product.left}</var>) <var>{matrix}</var>(<var>{product.right}</var>).{" "}
            {words.turns(<var>{first}</var>, <var>{otherOf[first]}</var>)}
          </p>
        </>
      )}
    </section>
  );
}
