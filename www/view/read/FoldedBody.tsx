// What the folds hold: what the conventions multiply, the matrix that was chosen beside q, and vectors
// along the axis.
import { columnValues, declaredValues } from "../../copy/values.ts";
import type { Column, ReadReport } from "../../engine.ts";
import { namesOf } from "../../model/component_order.ts";
import { operatorOf } from "../../model/conventions.ts";
import type { Digits, Preset } from "../../model/page_state.ts";
import { exactArray, shownArray } from "../../number/format.ts";
import type { Store } from "../../state/store.ts";
import { wordsOf } from "../../words/conventions.ts";
import * as rulesWords from "../../words/parts/rules_list.tsx";
import * as columnWords from "../../words/read/column.ts";
import * as declaredWords from "../../words/read/declared.tsx";
import * as factWords from "../../words/read/facts.ts";
import { asked, type FoldedPart } from "../../words/read/folded.ts";
import { AskedFold } from "../parts/AskedFold.tsx";
import { Copy } from "../parts/Copy.tsx";
import { nameOf, presetItself } from "../parts/convention_names.ts";
import { editedMatrix } from "../parts/number_group.ts";
import { MatrixOf, RulesList } from "../parts/RulesList.tsx";
import { Matrix } from "../parts/Value.tsx";
import "./folded.css";

const loadSwingTwist = () => import("./SwingTwist.tsx").then(({ SwingTwist }) => SwingTwist);

export interface Given {
  report: ReadReport;
  store: Store;
  digits: Digits;
}

/** What is folded, by what its line says. */
export function FoldedBody({ of, ...given }: Given & { of: FoldedPart }) {
  switch (of) {
    case "products":
      return (
        <>
          <Rules {...given} />
          <PairedMatrix {...given} />
        </>
      );
    case "tangents":
      return (
        <>
          <Tangents {...given} />
          <AskedFold
            store={given.store}
            name="swing-twist"
            summary={asked["swing-twist"]}
            load={loadSwingTwist}
          />
        </>
      );
  }
}

function Rules(given: Given) {
  const { store } = given;
  const { declared } = given.report;
  const { convention, rules } = declared;
  const isPreset = presetItself(convention, store.engine) !== undefined;
  return (
    <div class="fold-columns">
      {!isPreset && (
        <div class="declared">
          <h3>{rulesWords.multiplies}</h3>
          <RulesList
            name={rulesWords.multiplies}
            rules={rules}
            perturbation={convention.perturbation}
          >
            <li>{rulesWords.components(rules.isCanonical)}</li>
          </RulesList>
          <ProductMatrices
            column={declared}
            name={nameOf(convention, store.engine) ?? declaredWords.yours}
            order={`[${namesOf[convention.order].join(", ")}]`}
            {...given}
          />
        </div>
      )}
      <Products preset="hamilton" {...given} />
      <Products preset="jpl" {...given} />
    </div>
  );
}

function Products({ report, preset, ...given }: Given & { preset: Preset }) {
  const column = report[preset];
  const { name, order } = wordsOf[preset];
  return (
    <div class={preset}>
      <h3>{name}</h3>
      <RulesList
        name={rulesWords.multipliesAs(name)}
        rules={column.rules}
        perturbation={column.convention.perturbation}
      />
      <ProductMatrices column={column} name={name} order={order} {...given} />
    </div>
  );
}

/** By which a product with q is multiplied out, on arrays in the order of the convention. */
function ProductMatrices({
  column,
  name,
  order,
  store,
  digits,
}: Omit<Given, "report"> & { column: Column; name: string; order: string }) {
  const values = columnValues(column, store.engine.describe);
  const isUnit = column.unit.array.every((number, at) => number === column.quaternion.array[at]);
  const caption = columnWords.onOrder[isUnit ? "unit" : "typed"](order);
  return (
    <div class="matrices">
      <Matrix
        name={columnWords.leftProductOf(name)}
        symbol={
          <>
            <var>q</var>∘<var>p</var> = <var>L p</var>
          </>
        }
        caption={caption}
        rows={column.leftProductMatrix}
        value={values.left}
        digits={digits}
      />
      <Matrix
        name={columnWords.rightProductOf(name)}
        symbol={
          <>
            <var>p</var>∘<var>q</var> = <var>R p</var>
          </>
        }
        caption={caption}
        rows={column.rightProductMatrix}
        value={values.right}
        digits={digits}
      />
    </div>
  );
}

/** The matrix of the function and direction that were chosen for matrices. */
function PairedMatrix({ report, store, digits }: Given) {
  const { paired } = report;
  return (
    <Matrix
      name={declaredWords.pairedMatrix}
      symbol={<MatrixOf form={paired.form} />}
      caption={declaredWords.paired(paired.convention)}
      rows={paired.rows}
      value={declaredValues(report, store.engine.describe).paired}
      digits={digits}
      edited={editedMatrix(store, "paired-matrix", operatorOf(paired.convention))}
    />
  );
}

/** Vectors along the axis whose length is a tangent. */
function Tangents({ report: { turn }, digits }: Given) {
  const tangents = [
    { ...factWords.gibbs, text: "gibbs", vector: turn.gibbsVector },
    { ...factWords.rodrigues, text: "mrp", vector: turn.modifiedRodriguesParameters },
  ];
  return (
    <div class="fold-columns">
      {tangents.map(({ name, of, vector, text, note }) => (
        <div key={name} class="tangent">
          <h3>{name}</h3>
          <p class="fact-value">
            {vector === undefined ? (
              factWords.infinite
            ) : (
              <>
                <code>{shownArray(vector, digits)}</code>
                <Copy of={of} text={`${text} ${exactArray(vector)}`} />
              </>
            )}
          </p>
          <p>{note}</p>
        </div>
      ))}
    </div>
  );
}
