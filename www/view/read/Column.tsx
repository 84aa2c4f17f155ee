// One attitude in one convention: components, matrix, inverse, the image of the vector.
import { columnValues } from "../../copy/values.ts";
import type { Column } from "../../engine.ts";
import type { Digits, Preset } from "../../model/page_state.ts";
import { shownArray } from "../../number/format.ts";
import type { Store } from "../../state/store.ts";
import { asDeclared, wordsOf } from "../../words/conventions.ts";
import * as text from "../../words/read/column.ts";
import { editedComponents, editedMatrix } from "../parts/number_group.ts";
import { ArrayRow, ComponentStrip, Matrix } from "../parts/Value.tsx";
import "../parts/result.css";

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
  // What would be the same numbers three times is told once.
  const isUnit =
    shownArray(column.unit.array, digits) === shownArray(column.quaternion.array, digits);
  return (
    <section class={`card column ${preset}`} aria-labelledby={`${preset}-name`}>
      <header>
        <h2 id={`${preset}-name`}>{words.name}</h2>
        {preset === declared && <span class="badge">{asDeclared}</span>}
        <p class="effect">
          {words.product} · {words.direction}
        </p>
      </header>
      <ComponentStrip
        symbol="q"
        name={`${words.name} q`}
        components={column.quaternion}
        convention={column.convention}
        value={values.quaternion}
        digits={digits}
        edited={editedComponents(store, `${preset}-components`, column.convention, "preset")}
        copied="below"
      />
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
            <sup>−1</sup>
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
              {isUnit && (
                <>
                  {" = "}
                  <var>q</var>
                  <sup>−1</sup>
                </>
              )}
            </>
          }
          numbers={column.conjugate.array}
          value={values.conjugate}
          digits={digits}
          note={isUnit ? undefined : text.conjugate}
        />
        {!isUnit && (
          <>
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
              note={text.inverse}
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
              note={text.unit}
            />
          </>
        )}
      </div>
    </section>
  );
}
