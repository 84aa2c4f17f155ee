// One attitude in one convention: components, matrices, the image of the vector, the inverse.
import { columnValues } from "../../copy/values.ts";
import type { Column } from "../../engine.ts";
import type { Digits, Preset } from "../../model/page_state.ts";
import type { Store } from "../../state/store.ts";
import { wordsOf } from "../../words/conventions.ts";
import { multipliesAs } from "../../words/parts/rules_list.tsx";
import * as text from "../../words/read/column.ts";
import { editedComponents, editedMatrix } from "../parts/number_group.ts";
import { RulesList } from "../parts/RulesList.tsx";
import { ArrayRow, ComponentStrip, Matrix } from "../parts/Value.tsx";
import "../parts/result.css";
import "./column.css";

export function ConventionColumn({
  store,
  preset,
  declared,
  column,
  digits,
}: {
  store: Store;
  preset: Preset;
  /** The preset that was declared; none where the convention is another one. */
  declared: Preset | undefined;
  column: Column;
  digits: Digits;
}) {
  const words = wordsOf[preset];
  const { describe } = store.engine;
  const { direction } = column.convention;
  const values = columnValues(column, describe);
  const matrix = (
    <>
      <var>{words.matrix}</var>(<var>q</var>)
    </>
  );
  const isUnit = column.unit.array.every((number, at) => number === column.quaternion.array[at]);
  const normOf = isUnit ? "unit" : "typed";
  return (
    <section class={`card column ${preset}`} aria-labelledby={`${preset}-name`}>
      <header>
        <h2 id={`${preset}-name`}>{words.name}</h2>
        {preset === declared && <span class="badge">{text.asDeclared}</span>}
        <p class="axes">
          <span>{words.product}</span> <span>{words.order}</span> <span>{words.direction}</span>
        </p>
        <p class="effect">{words.effect}</p>
      </header>
      <ComponentStrip
        symbol="q"
        name={`${words.name} q`}
        components={column.quaternion}
        convention={column.convention}
        value={values.quaternion}
        digits={digits}
        edited={editedComponents(store, `${preset}-components`, column.convention, "preset")}
      />
      <div class="matrices">
        <Matrix
          name={`${words.matrix}(q)`}
          symbol={matrix}
          caption={words.direction}
          rows={column.matrix}
          value={values.matrix}
          digits={digits}
          edited={editedMatrix(store, `${preset}-matrix`, direction)}
        />
        <Matrix
          name={text.inverseOf(`${words.matrix}(q)`)}
          symbol={
            <>
              {matrix}
              <sup>−1</sup> = {matrix}
              <sup>T</sup>
            </>
          }
          caption={words.reversed}
          rows={column.inverseMatrix}
          value={values.inverseMatrix}
          digits={digits}
          edited={editedMatrix(
            store,
            `${preset}-inverse-matrix`,
            describe(column.convention).reversed.direction,
          )}
        />
      </div>
      <div class="rows">
        <ArrayRow
          name={`${words.matrix}(q) v`}
          symbol={
            <>
              {matrix} <var>v</var>
            </>
          }
          numbers={column.image}
          value={values.image}
          digits={digits}
          note={words.vector}
        />
        <ArrayRow
          name={text.conjugateOf(words.name)}
          symbol={
            <>
              <var>q</var>*
            </>
          }
          numbers={column.conjugate.array}
          value={values.conjugate}
          digits={digits}
          note={text.conjugate}
        />
        <ArrayRow
          name={text.inverseQuaternionOf(words.name)}
          symbol={
            <>
              <var>q</var>
              <sup>−1</sup>
            </>
          }
          numbers={column.inverse?.array}
          value={values.inverse}
          digits={digits}
          note={isUnit ? text.inverseOfUnit : text.inverse}
        />
        <ArrayRow
          name={text.unitOf(words.name)}
          symbol={
            <>
              <var>q</var>/|<var>q</var>|
            </>
          }
          numbers={column.unit.array}
          value={values.unit}
          digits={digits}
          note={isUnit ? text.unitItself : text.unit}
        />
      </div>
      <RulesList
        name={multipliesAs(words.name)}
        rules={column.rules}
        perturbation={column.convention.perturbation}
      />
      <details class="products">
        <summary>{text.productMatrices}</summary>
        <div class="matrices">
          <Matrix
            name={text.leftProductOf(words.name)}
            symbol={
              <>
                <var>q</var>∘<var>p</var> = <var>L p</var>
              </>
            }
            caption={text.onOrder[normOf](words.order)}
            rows={column.leftProductMatrix}
            value={values.left}
            digits={digits}
          />
          <Matrix
            name={text.rightProductOf(words.name)}
            symbol={
              <>
                <var>p</var>∘<var>q</var> = <var>R p</var>
              </>
            }
            caption={text.onOrder[normOf](words.order)}
            rows={column.rightProductMatrix}
            value={values.right}
            digits={digits}
          />
        </div>
      </details>
    </section>
  );
}
