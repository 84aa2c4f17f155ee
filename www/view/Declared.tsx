// The declared convention where it is neither preset: its own numbers, and what it multiplies.
import type { ComponentChildren } from "preact";
import type { Digits } from "../address.ts";
import { declaredValues } from "../copy/values.ts";
import type { ReadReport, Rules, Side } from "../engine.ts";
import type { Store } from "../state.ts";
import { asDeclared } from "../words/column.ts";
import { arrowOf } from "../words/conventions.ts";
import * as words from "../words/declared.tsx";
import { fiveWords, nameOf } from "./conventions.ts";
import { editedComponents, editedMatrix } from "./number_group.ts";
import { ArrayRow, ComponentStrip, Matrix } from "./Value.tsx";

export function DeclaredCard({
  report,
  store,
  digits,
}: {
  report: ReadReport;
  store: Store;
  digits: Digits;
}) {
  const { declared, rules } = report;
  const name = nameOf(declared.convention, store.engine);
  const { function: does } = declared.convention;
  const values = declaredValues(declared);
  const act = (
    <>
      <var>q</var>∘<var>x</var>∘<var>q</var>
      <sup>−1</sup>
    </>
  );
  return (
    <section class="card column declared" aria-labelledby="declared-name">
      <header>
        <h2 id="declared-name">{name ?? words.yours}</h2>
        <span class="badge">{asDeclared}</span>
        <p class="axes-words">{fiveWords(declared.convention)}</p>
      </header>
      <div class="declared-body">
        <div>
          <ComponentStrip
            symbol="q"
            name={words.named("q")}
            components={declared.quaternion}
            convention={declared.convention}
            value={values.quaternion}
            digits={digits}
            edited={editedComponents(store, "declared-components", declared.convention, "declared")}
          />
          <div class="rows">
            <ArrayRow
              name={words.named("x")}
              symbol={act}
              numbers={declared.image}
              value={values.image}
              digits={digits}
              note={words.coordinates[does](arrowOf(rules.operator))}
            />
          </div>
        </div>
        <Matrix
          name={words.matrix}
          symbol={<>{act} =</>}
          caption={words.matrixDoes[does](arrowOf(rules.operator))}
          rows={declared.matrix}
          value={values.matrix}
          digits={digits}
          edited={editedMatrix(store, "declared-matrix", rules.operator)}
        />
        <RulesList rules={rules} />
      </div>
    </section>
  );
}

/** What the convention multiplies in which order. */
function RulesList({ rules }: { rules: Rules }) {
  return (
    <ul class="rules" aria-label={words.multiplies}>
      <li>{words.components(rules.isCanonical)}</li>
      <li>
        {words.labels(
          <Product first={<Q of="AB" />} second={<Q of="BC" />} side={rules.labelledFirst} />,
          <Q of="AC" />,
        )}
      </li>
      <li>
        {words.camera(
          <Product first={<Q of="WB" />} second={<Q of="BC" />} side={rules.chainFirst} />,
        )}
      </li>
      <li>
        {words.increment(
          <Product first={<var>δq</var>} second={<var>q</var>} side={rules.increment} />,
        )}
      </li>
      <li>
        {words.bodyRate(
          <>
            <var>q̇</var> = {rules.isCanonical ? "½" : "−½"}{" "}
            <Product first={<var>ω</var>} second={<var>q</var>} side={rules.bodyRate} />
          </>,
        )}
      </li>
    </ul>
  );
}

function Q({ of }: { of: string }) {
  return (
    <>
      <var>q</var>
      <sub>{of}</sub>
    </>
  );
}

/** Two factors, the first of them on this side. */
function Product({
  first,
  second,
  side,
}: {
  first: ComponentChildren;
  second: ComponentChildren;
  side: Side;
}) {
  const [left, right] = side === "left" ? [first, second] : [second, first];
  return (
    <span class="factors">
      {left}∘{right}
    </span>
  );
}
