// The declared convention where it is neither preset: its own numbers and its matrix.
import { declaredValues } from "../../copy/values.ts";
import type { ReadReport } from "../../engine.ts";
import type { Digits } from "../../model/page_state.ts";
import type { Store } from "../../state/store.ts";
import { arrowOf, asDeclared } from "../../words/conventions.ts";
import * as words from "../../words/read/declared.tsx";
import { fiveWords, nameOf } from "../parts/convention_names.ts";
import { editedComponents, editedMatrix } from "../parts/number_group.ts";
import { ArrayRow, ComponentStrip, Matrix } from "../parts/Value.tsx";
import "../parts/result.css";
import "./declared.css";

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
  const values = declaredValues(report, store.engine.describe);
  const act = (
    <>
      <var>q</var>∘<var>v</var>∘<var>q</var>
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
            copied="below"
          />
          <div class="rows">
            <ArrayRow
              name={words.named("v")}
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
      </div>
    </section>
  );
}
