// The Compose view: two quaternions, both products, both orders.
import { type ComponentChildren, Fragment } from "preact";
import { useState } from "preact/hooks";
import { productValues } from "../../copy/values.ts";
import type {
  ComposeReport,
  Engine,
  Frame,
  Handedness,
  Operand,
  Product,
  Turn,
} from "../../engine.ts";
import { presetOf } from "../../model/conventions.ts";
import type { Digits, Unit } from "../../model/page_state.ts";
import { shownAngle, shownArray, shownAxis } from "../../number/format.ts";
import type { Store } from "../../state/store.ts";
import * as words from "../../words/compose/compose.tsx";
import { arrowOf, asDeclared, wordsOf } from "../../words/conventions.ts";
import { AskRest } from "../parts/Ask.tsx";
import { CarryLinks } from "../parts/CarryLinks.tsx";
import { Choice } from "../parts/Choice.tsx";
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

export function Compose({ store }: { store: Store }) {
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
          {shownResult && <ReadAs report={shownResult.report} store={store} />}
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

/** How each text was read and what there is to know of it, in a line of its own. */
function ReadAs({ report, store }: { report: ComposeReport; store: Store }) {
  const { digits, unit } = store.state.value;
  return (
    <div class="read-as">
      {operands.map((operand) => (
        <div key={operand}>
          <ReadOperand operand={operand} report={report} digits={digits} unit={unit} />
          <Notes notes={report.notes.filter(({ field }) => field === operand)} store={store} />
        </div>
      ))}
      <Notes notes={report.notes.filter(({ field }) => field === "vector")} store={store} />
    </div>
  );
}

function ReadOperand({
  operand,
  report,
  digits,
  unit,
}: Pick<ShownAs, "digits" | "unit"> & { operand: Operand; report: ComposeReport }) {
  return (
    <p>
      <var>{operand}</var>{" "}
      <NamedComponents quaternion={report[operand]} digits={digits} unit={unit} />
    </p>
  );
}

const operands: readonly Operand[] = ["p", "q"];
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
  const carryLinks = (
    <CarryLinks
      store={store}
      of={spelled(declared)}
      quaternion={{ components: declared.quaternion, convention: declared.convention }}
      to={["read", "translate"]}
    />
  );
  return (
    <div class={`composed composed-${digits}`}>
      <div class="products">
        {!isPreset && (
          <ProductCard product={declared} {...shownAs}>
            {carryLinks}
          </ProductCard>
        )}
        {headline && (
          <Pair tied={headline.tied} tie={isPreset ? words.tie : words.tieOfPresets} {...shownAs}>
            {isPreset && carryLinks}
          </Pair>
        )}
      </div>
      <Road report={report} engine={store.engine} digits={digits} unit={unit} />
      <Picture store={store} of="compose" />
      {others.map(({ key, tied }) => (
        <details key={key} class="fold">
          <summary>{words.otherOrder(tied.map(spelled).join(" = "))}</summary>
          <Pair tied={tied} tie={words.tie} {...shownAs} />
        </details>
      ))}
    </div>
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

/** Two products that have the same numbers; where there is room for one, a switch says which. */
function Pair({
  tied,
  tie,
  children,
  ...shownAs
}: ShownAs & { tied: readonly Product[]; tie: string; children?: ComponentChildren }) {
  const [asked, ask] = useState<string>();
  const products = tied.map(spelled);
  const shown = asked !== undefined && products.includes(asked) ? asked : (products[0] ?? "");
  return (
    <section class="pair" aria-label={products.join(` ${words.equals} `)}>
      <h2 class="tie">
        {tied.map((product, at) => (
          <Fragment key={spelled(product)}>
            {at > 0 && <span class="tie-sign"> = </span>}
            <span class={presetOf[product.convention.handedness]}>
              <Formula product={product} />
            </span>
          </Fragment>
        ))}{" "}
        <span class="tie-words">{tie}</span>
      </h2>
      {children}
      <Choice
        kind="choice"
        group={products.join()}
        legend={words.shownProduct}
        values={tied.map((product) => ({
          value: spelled(product),
          words: (
            <span>
              {wordsOf[presetOf[product.convention.handedness]].name} <Formula product={product} />
            </span>
          ),
        }))}
        chosen={shown}
        choose={ask}
      />
      <div class="columns">
        {tied.map((product) => (
          <ProductCard
            key={spelled(product)}
            product={product}
            place={spelled(product) === shown ? "shown" : "switched-off"}
            {...shownAs}
          />
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

function ProductCard({
  product,
  engine,
  declared,
  digits,
  unit,
  place = "shown",
  children,
}: ShownAs & {
  product: Product;
  /** Where there is room for one product of a pair. */
  place?: "shown" | "switched-off";
  children?: ComponentChildren;
}) {
  const { preset } = engine.describe(product.convention);
  const { name, matrix } = preset
    ? wordsOf[preset]
    : { name: nameOf(product.convention, engine) ?? words.yourConvention, matrix: undefined };
  const isDeclared =
    product.left === declared.left && preset === engine.describe(declared.convention).preset;
  const [start, middle, end] = framesOf(product);
  const first = product.firstAboutFixedAxes;
  const values = productValues(product, engine.describe);
  return (
    <section
      class={`card column product ${preset ?? "custom"} ${place}`}
      aria-label={`${name}: ${spelled(product)}`}
    >
      <header>
        <h3>
          {name}{" "}
          <span class="product-formula">
            <Formula product={product} />
          </span>
        </h3>
        {isDeclared && <span class="badge">{asDeclared}</span>}
        <p class="effect">
          {words.firstThen(<var>{product.right}</var>, <var>{product.left}</var>)} · {start} →{" "}
          {middle} → {end}
        </p>
        {children}
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
      <Rotation turn={product.turn} digits={digits} unit={unit} />
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
            <span class="turns-product">
              <var>{matrix}</var>(<Formula product={product} />) = <var>{matrix}</var>(
              <var>{product.left}</var>) <var>{matrix}</var>(<var>{product.right}</var>).
            </span>{" "}
            {words.turns(<var>{first}</var>, <var>{otherOf[first]}</var>)}
          </p>
        </>
      )}
    </section>
  );
}

/** What a product does to the body, as axis and angle. */
function Rotation({
  turn: { axis, angleDeg, angleRad },
  digits,
  unit,
}: Pick<ShownAs, "digits" | "unit"> & { turn: Turn }) {
  return (
    <div class="row product-turn">
      <span class="row-symbol">{words.rotation}</span>
      <span class="row-value">
        {axis === undefined ? (
          words.noRotation
        ) : (
          <>
            <code>{shownAngle({ degrees: angleDeg, radians: angleRad }, digits, unit)}</code>
            <span>
              {words.about} <code>{shownAxis(axis, digits)}</code>
            </span>
          </>
        )}
      </span>
    </div>
  );
}
