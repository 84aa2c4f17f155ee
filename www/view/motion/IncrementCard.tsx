// An attitude after a small turn, in every convention, and what goes wrong with it.
import { incrementValues, turnedValue } from "../../copy/motion_values.ts";
import type { IncrementReport, SidedQuaternion } from "../../engine.ts";
import { declaredConvention } from "../../model/conventions.ts";
import { fromRadians, shown, shownAngle } from "../../number/format.ts";
import type { Store } from "../../state/store.ts";
import * as words from "../../words/motion/motion.tsx";
import { ArrayRow, ComponentStrip, Matrix } from "../parts/Value.tsx";
import { Mistakes } from "./Mistakes.tsx";
import { formulaOf, SidedStrips } from "./Sided.tsx";

const plus = (row: SidedQuaternion) => formulaOf(row, "q ⊕ δ = ", (sign) => `Exp(${sign}δ)`);
const minus = (row: SidedQuaternion) =>
  formulaOf({ ...row, sign: -row.sign }, "q ⊕ (−δ) = ", (sign) => `Exp(${sign}δ)`);

export function IncrementCard({ store, increment }: { store: Store; increment: IncrementReport }) {
  const { digits, unit } = store.state.value;
  const isLocal = declaredConvention(store.state.value).perturbation === "local";
  const [own, other] = isLocal ? [0, 3] : [3, 0];
  const [declared] = increment.plus.slice(own);
  const [quaternionOff, matrixOff, turnOff] = increment.smallAngleOff;
  const values = declared && incrementValues(increment, declared, store.engine.describe);
  const strips = (rows: readonly SidedQuaternion[], from: number, formula = plus) => (
    <SidedStrips
      store={store}
      rows={rows.slice(from, from + 3)}
      symbol="q"
      name={formula === plus ? words.after : words.before}
      formula={formula}
      value={turnedValue}
    />
  );
  return (
    <>
      {strips(increment.plus, own)}
      <ArrayRow
        name={words.onBody}
        symbol={<>δ {words.onBody}</>}
        numbers={increment.bodyRad}
        value={values?.body}
        digits={digits}
      />
      <ArrayRow
        name={words.onWorld}
        symbol={<>δ {words.onWorld}</>}
        numbers={increment.worldRad}
        value={values?.world}
        digits={digits}
      />
      <Mistakes store={store} mistakes={increment.mistakes} />
      <details class="fold">
        <summary>{words.more}</summary>
        <div class="motion-more">
          {declared && (
            <ComponentStrip
              symbol="δq"
              name={words.errorQuaternion}
              components={declared.factor}
              value={values?.error}
              convention={declared.convention}
              digits={digits}
            />
          )}
          {declared && (
            <ComponentStrip
              symbol="[1, δ/2]"
              name={words.smallAngle}
              components={increment.smallAngleQuaternion}
              value={values?.smallQuaternion}
              convention={declared.convention}
              digits={digits}
            />
          )}
          <Matrix
            name={words.smallMatrix}
            symbol="I + [δ]×"
            rows={increment.smallAngleMatrix}
            value={values?.smallMatrix}
            digits={digits}
          />
          <p>
            {words.offBy(
              shown(quaternionOff, "4"),
              shown(matrixOff, "4"),
              shownAngle(fromRadians(turnOff), "4", unit),
            )}
          </p>
          <Matrix
            name={words.matrixAfter}
            symbol="R(q ⊕ δ), body → world"
            rows={increment.bodyToWorld}
            value={values?.matrix}
            digits={digits}
          />
          <h3>{words.otherAxes[isLocal ? "world" : "body"]}</h3>
          {strips(increment.plus, other)}
          <h3>{words.taken}</h3>
          {strips(increment.minus, own, minus)}
        </div>
      </details>
    </>
  );
}
