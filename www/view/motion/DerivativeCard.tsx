// How an attitude changes at a rate.
import { derivativeValue, omegaValue, rateValues } from "../../copy/motion_values.ts";
import type { DerivativeReport, SidedQuaternion } from "../../engine.ts";
import { sequenceName } from "../../model/euler_sequence.ts";
import { shown } from "../../number/format.ts";
import type { Store } from "../../state/store.ts";
import * as words from "../../words/motion/motion.tsx";
import { ArrayRow, Matrix } from "../parts/Value.tsx";
import { distinct, formulaOf, nameIn, SidedStrips } from "./Sided.tsx";

const formula = (row: SidedQuaternion) =>
  formulaOf({ ...row, sign: 1 }, row.sign < 0 ? "q̇ = −½ " : "q̇ = ½ ", () => "ω");

export function DerivativeCard({
  store,
  derivative,
}: {
  store: Store;
  derivative: DerivativeReport;
}) {
  const { digits, unit } = store.state.value;
  const { quaternions, euler, eulerRatesRad, eulerDeterminant, vectorRateRad } = derivative;
  const values = rateValues(derivative);
  const sequence = sequenceName(euler.sequence);
  const inUnit = (radians: number) => (unit === "degrees" ? (radians * 180) / Math.PI : radians);
  const per = unit === "degrees" ? "°/s" : "rad/s";
  return (
    <>
      <SidedStrips
        store={store}
        rows={quaternions}
        symbol="q̇"
        name={words.derivativeOf}
        formula={formula}
        value={derivativeValue}
      />
      <ArrayRow
        name={`ω ${words.onBody}`}
        symbol={<>ω {words.onBody}</>}
        numbers={derivative.bodyRad}
        value={values.body}
        digits={digits}
      />
      <ArrayRow
        name={`ω ${words.onWorld}`}
        symbol={<>ω {words.onWorld}</>}
        numbers={derivative.worldRad}
        value={values.world}
        digits={digits}
      />
      {eulerRatesRad ? (
        <ArrayRow
          name={words.eulerRates(sequence)}
          symbol={`${words.eulerName} ${sequence}, ${per}`}
          numbers={eulerRatesRad.map(inUnit)}
          value={values.eulerRates(
            eulerRatesRad.map(inUnit),
            unit === "degrees" ? "deg/s" : "rad/s",
          )}
          digits={digits}
          note={words.determinant(shown(eulerDeterminant, "4"))}
        />
      ) : (
        <p class="motion-stop">
          {words.eulerName} {sequence}: {words.locked}
        </p>
      )}
      {vectorRateRad ? (
        <ArrayRow
          name={words.vectorRate}
          symbol={words.vectorName}
          numbers={vectorRateRad}
          value={values.vectorRate}
          digits={digits}
        />
      ) : (
        <p class="motion-stop">
          {words.vectorName}: {words.wholeTurn}
        </p>
      )}
      <details class="fold">
        <summary>{words.more}</summary>
        <div class="motion-more">
          {distinct(quaternions).map((row) => (
            <Matrix
              key={nameIn(row.convention)}
              name={words.omega(nameIn(row.convention))}
              symbol={words.omega(nameIn(row.convention))}
              rows={row.matrix}
              value={omegaValue(row)}
              digits={digits}
            />
          ))}
          <Matrix
            name={words.matrixRate}
            symbol="Ṙ, body → world"
            rows={derivative.bodyToWorld}
            value={values.matrix}
            digits={digits}
          />
          <Matrix
            name={words.rightJacobian}
            symbol="J_r"
            rows={derivative.rightJacobian}
            value={values.jacobian}
            digits={digits}
          />
          {derivative.rightJacobianInverse && (
            <Matrix
              name={words.inverseJacobian}
              symbol="J_r⁻¹"
              rows={derivative.rightJacobianInverse}
              value={values.inverse}
              digits={digits}
            />
          )}
        </div>
      </details>
    </>
  );
}
