// The Compose view: two quaternions, both products, both orders.
import type { Digits } from "../address.ts";
import type { ComposeReport, Engine, Frame, Handedness, Operand, Product } from "../engine.ts";
import { shownArray } from "../format.ts";
import type { Store } from "../state.ts";
import { AskRest, ConventionSwitch, TextField } from "./Ask.tsx";
import { NamedComponents } from "./Form.tsx";
import { Notes } from "./Notes.tsx";
import { ComponentStrip, Matrix } from "./Value.tsx";
import { arrowOf, nameOf, presetLike, presetOf, wordsOf } from "./words.ts";

export function Compose({ store }: { store: Store }) {
  const { digits } = store.state.value;
  const shownResult = store.compose.value;
  return (
    <>
      <section class="ask" aria-label="Input">
        <div class="ask-row">
          <div class="ask-pair">
            <TextField store={store} field="p" />
            <TextField store={store} field="q" />
          </div>
          <ConventionSwitch store={store} />
        </div>
        <AskRest store={store} freshness={shownResult?.freshness}>
          {shownResult && (
            <div class="read-as">
              <p>
                <var>p</var> <NamedComponents quaternion={shownResult.report.p} digits={digits} />
              </p>
              <p>
                <var>q</var> <NamedComponents quaternion={shownResult.report.q} digits={digits} />
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
      {pairs.map(({ hamilton, jpl }) => (
        <section
          key={hamilton.left}
          class="pair"
          aria-label={`${spelled(hamilton)} equals ${spelled(jpl)}`}
        >
          <h2 class="tie">
            <span class="hamilton">
              <Formula product={hamilton} />
            </span>{" "}
            <span class="tie-sign">=</span>{" "}
            <span class="jpl">
              <Formula product={jpl} />
            </span>
            <span class="tie-words">the same numbers, transposed matrices</span>
          </h2>
          <div class="columns">
            <ProductCard product={hamilton} digits={digits} />
            <ProductCard product={jpl} digits={digits} />
          </div>
        </section>
      ))}
    </>
  );
}

function spelled({ left, right, convention }: Product): string {
  return `${left} ${signOf[convention.handedness]} ${right}`;
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
  const [start, middle, end] = product.frames.map((frame) => letterOf[frame]);
  const preset = presetLike(product.convention, engine);
  const name = preset ? wordsOf[preset].name : nameOf(product.convention, engine);
  const [afterRight, afterBoth] = product.images ?? [];
  return (
    <section class={`card road ${preset ?? "custom"}`} aria-labelledby="road-name">
      <h2 id="road-name">
        <Formula product={product} />: first <var>{product.right}</var>, then{" "}
        <var>{product.left}</var>
      </h2>
      {preset === undefined && (
        <ComponentStrip
          symbol={spelled(product)}
          name={`${spelled(product)} as declared`}
          components={product.quaternion}
          convention={product.convention}
          digits={digits}
        />
      )}
      <ol class="road-steps">
        <li>
          <span class="road-frame">
            <var>x</var> on the axes of {start}
          </span>
          <code>{shownArray(report.vector, digits)}</code>
        </li>
        <li>
          <span class="road-frame">
            after <var>{product.right}</var>, on the axes of {middle}
          </span>
          <code>{afterRight ? shownArray(afterRight, digits) : "beyond a double"}</code>
        </li>
        <li>
          <span class="road-frame">
            after <var>{product.left}</var>, on the axes of {end}
          </span>
          <code>{afterBoth ? shownArray(afterBoth, digits) : "beyond a double"}</code>
        </li>
      </ol>
      <p>
        In {name ?? "your convention"}, {arrowOf(product.direction)}, <var>{product.right}</var>{" "}
        leads from {start} to {middle} and <var>{product.left}</var> from {middle} to {end}: they
        meet in {middle}. W is the world, B the body, B′ a second body mounted on B.
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
      return (
        <p class="order-words">
          These two commute: all four products are the same quaternion, so they cannot show which
          order a program uses.
        </p>
      );
    case "only-in-sign":
      return (
        <p class="order-words">
          Swapped, these two give −1 times the same quaternion: the same rotation, so they cannot
          show which order a program uses.
        </p>
      );
  }
}

function ProductCard({ product, digits }: { product: Product; digits: Digits }) {
  const preset = presetOf[product.convention.handedness];
  const words = wordsOf[preset];
  const [start, middle, end] = product.frames.map((frame) => letterOf[frame]);
  const first = product.firstAboutFixedAxes;
  return (
    <section class={`card column ${preset}`} aria-label={`${words.name}: ${spelled(product)}`}>
      <header>
        <h3>
          {words.name} <Formula product={product} />
        </h3>
        <p class="axes">
          <span>
            {start} → {middle} → {end}
          </span>{" "}
          <span>
            first <var>{product.right}</var>, then <var>{product.left}</var>
          </span>
        </p>
      </header>
      <ComponentStrip
        symbol={spelled(product)}
        name={`${words.name} ${spelled(product)}`}
        components={product.quaternion}
        convention={product.convention}
        digits={digits}
      />
      <div class="matrices">
        <Matrix
          name={`${words.matrix}(${spelled(product)})`}
          symbol={
            <>
              <var>{words.matrix}</var>(<Formula product={product} />) = <var>{words.matrix}</var>(
              <var>{product.left}</var>) <var>{words.matrix}</var>(<var>{product.right}</var>)
            </>
          }
          caption={`${start} → ${end}`}
          rows={product.matrix}
          digits={digits}
        />
      </div>
      <p class="turns">
        As turns of the body: about the fixed axes first <var>{first}</var>, then{" "}
        <var>{otherOf[first]}</var>; about the moving axes first <var>{otherOf[first]}</var>, then{" "}
        <var>{first}</var>.
      </p>
    </section>
  );
}
