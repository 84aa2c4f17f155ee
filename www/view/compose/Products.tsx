// Products as cards: each with what it does to the body, and two of the same numbers as a pair.
import { type ComponentChildren, Fragment } from "preact";
import { useState } from "preact/hooks";
import { productValues } from "../../copy/product_values.ts";
import type { Operand, Product, Turn } from "../../engine.ts";
import { presetOf } from "../../model/conventions.ts";
import { shownAngle, shownAxis } from "../../number/format.ts";
import * as words from "../../words/compose/compose.tsx";
import { asDeclared, wordsOf } from "../../words/conventions.ts";
import { Choice } from "../parts/Choice.tsx";
import { nameOf, presetItself } from "../parts/convention_names.ts";
import { ComponentStrip, Matrix } from "../parts/Value.tsx";
import { Formula, framesOf, type ShownAs, spelled } from "./Formula.tsx";

/** Two products that have the same numbers; where there is room for one, a switch says which. */
export function Pair({
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
            heading="h3"
            place={spelled(product) === shown ? "shown" : "switched-off"}
            {...shownAs}
          />
        ))}
      </div>
    </section>
  );
}

const otherOf: Record<Operand, Operand> = { p: "q", q: "p" };

export function ProductCard({
  product,
  heading: Heading,
  engine,
  declared,
  digits,
  unit,
  place = "shown",
  children,
}: ShownAs & {
  product: Product;
  /** One below what it stands under. */
  heading: "h2" | "h3";
  /** Where there is room for one product of a pair. */
  place?: "shown" | "switched-off";
  children?: ComponentChildren;
}) {
  const preset = presetItself(product.convention, engine);
  const { name, matrix } = preset
    ? wordsOf[preset]
    : { name: nameOf(product.convention, engine) ?? words.yourConvention, matrix: undefined };
  const isDeclared =
    product.left === declared.left && preset === presetItself(declared.convention, engine);
  const [start, middle, end] = framesOf(product);
  const first = product.firstAboutFixedAxes;
  const values = productValues(product, engine.describe);
  return (
    <section
      class={`card column product ${preset ?? "custom"} ${place}`}
      aria-label={`${name}: ${spelled(product)}`}
    >
      <header>
        <Heading>
          {name}{" "}
          <span class="product-formula">
            <Formula product={product} />
          </span>
        </Heading>
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
            <code>{shownAngle({ degrees: angleDeg, radians: angleRad }, digits, unit)}</code>{" "}
            <span>
              {words.about} <code>{shownAxis(axis, digits)}</code>
            </span>
          </>
        )}
      </span>
    </div>
  );
}
