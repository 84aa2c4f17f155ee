// Beside a motion: a covariance on the other axes, and how the image of a point changes with the attitude.
import type { ComponentChildren } from "preact";
import { covarianceValue, pointValues } from "../../copy/motion_values.ts";
import type { Request } from "../../engine.ts";
import { declaredConvention } from "../../model/conventions.ts";
import type { Copied } from "../../model/copied.ts";
import type { PageState } from "../../model/page_state.ts";
import type { Store } from "../../state/store.ts";
import { arrowOf, lettersOf } from "../../words/conventions.ts";
import * as words from "../../words/motion/of_vectors.ts";
import { AskedText, useAsked } from "../parts/asked.tsx";
import { ArrayRow, Matrix } from "../parts/Value.tsx";

const asked = (state: PageState) => ({
  view: "motion" as const,
  quaternion: state.quaternion,
  convention: declaredConvention(state),
  matrix: state.matrix,
});
const askedOfCovariance = (state: PageState): Request => ({
  ...asked(state),
  covariance: state.covariance,
});
const askedOfPoint = (state: PageState): Request => ({ ...asked(state), point: state.point });

export function Covariance({ store }: { store: Store }) {
  const { report, problems, old } = useAsked(store, askedOfCovariance, "motion");
  const { covariance, digits } = store.state.value;
  const { perturbation } = declaredConvention(store.state.value);
  const axes = (["body", "world"] as const).map((name) => (
    <Matrix
      key={name}
      name={words.covarianceOn[name]}
      symbol={words.covarianceOn[name]}
      rows={report?.covariance?.[name] ?? []}
      value={report?.covariance && covarianceValue(report.covariance, name)}
      digits={digits}
    />
  ));
  return (
    <section class="card asked" aria-label={words.covariance}>
      <p class="asked-lead">{words.covarianceLead[perturbation]}</p>
      <AskedText
        label={words.covariance}
        symbol="P"
        text={covariance}
        problem={problems.find(({ field }) => field === "covariance")}
        onInput={(covariance) => store.set({ covariance }, { as: "covariance" })}
      />
      {report?.covariance && (
        <div class={`asked-columns ${old}`}>{perturbation === "local" ? axes : axes.reverse()}</div>
      )}
    </section>
  );
}

export function Point({ store }: { store: Store }) {
  const { report, problems, old } = useAsked(store, askedOfPoint, "motion");
  const { point, digits } = store.state.value;
  const changes = report?.point;
  const convention = declaredConvention(store.state.value);
  const { order } = convention;
  const { operator } = store.engine.describe(convention).rules;
  const values = changes && pointValues(changes, lettersOf[order]);
  const matrix = (
    name: string,
    symbol: ComponentChildren,
    rows: readonly (readonly number[])[],
    value: Copied | undefined,
  ) => (
    <Matrix name={name} symbol={symbol} caption={name} rows={rows} digits={digits} value={value} />
  );
  return (
    <section class="card asked" aria-label={words.point}>
      <AskedText
        label={words.point}
        symbol="x"
        text={point}
        problem={problems.find(({ field }) => field === "point")}
        onInput={(point) => store.set({ point }, { as: "point" })}
      />
      {changes && (
        <div class={old}>
          <ArrayRow
            name={words.image}
            symbol={words.image}
            numbers={changes.world}
            value={values?.image}
            digits={digits}
          />
          <div class="asked-columns">
            {matrix(
              words.byBodyTurn,
              "∂(R x)/∂δ = −R [x]×",
              changes.byBodyTurn,
              values?.byBodyTurn,
            )}
            {matrix(
              words.byWorldTurn,
              "∂(R x)/∂δ = −[R x]×",
              changes.byWorldTurn,
              values?.byWorldTurn,
            )}
          </div>
          {matrix(
            words.byComponents(arrowOf(operator), lettersOf[order]),
            "∂(q∘x∘q*)/∂q",
            changes.byComponents,
            values?.byComponents,
          )}
        </div>
      )}
    </section>
  );
}
