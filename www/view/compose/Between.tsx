// How p and q differ: what they are to each other, the rotation between, and the way from one to the other.
import { columnValues } from "../../copy/values.ts";
import type { BetweenReport, Field, RateBetween, Request } from "../../engine.ts";
import { declaredConvention } from "../../model/conventions.ts";
import { sequenceName } from "../../model/euler_sequence.ts";
import type { PageState } from "../../model/page_state.ts";
import {
  fromDegrees,
  fromRadians,
  shown,
  shownAngle,
  shownAxis,
  shownRoughAngle,
} from "../../number/format.ts";
import { BetweenPicture } from "../../picture/BetweenPicture.tsx";
import type { Store } from "../../state/store.ts";
import * as words from "../../words/compose/between.tsx";
import { wordsOf } from "../../words/conventions.ts";
import { AskedText, ScalarRow, useAsked } from "../parts/asked.tsx";
import { ArrayRow } from "../parts/Value.tsx";
import "./between.css";

export function askedOfBetween(state: PageState): Request {
  const { p, q, matrix, euler, part, within: duration } = state;
  const convention = declaredConvention(state);
  return { view: "between", p, q, convention, matrix, euler, part, duration };
}

/** Of a turn or a rate, by the axes that it is about. */
const sides = ["local", "global"] as const;

export function Between({ store }: { store: Store }) {
  const { report, problems, old } = useAsked(store, askedOfBetween, "between");
  const { part, within } = store.state.value;
  const problemOf = (name: Field) => problems.find(({ field }) => field === name);
  const isUnread = problemOf("p") ?? problemOf("q");
  const move = (part: string) => store.set({ part }, { as: "part" });
  return (
    <section class="card asked" aria-label={words.title}>
      {report === undefined ? (
        <p class="asked-lead">{isUnread && words.unread}</p>
      ) : (
        <div class={`asked ${old}`}>
          <p class="asked-sentence" role="status">
            {sentenceOf(store, report)}
          </p>
          {isHalfTurn(report) && <p class="asked-lead">{words.halfTurn}</p>}
          <Differences store={store} report={report} />
        </div>
      )}
      <div class="between-way">
        <div class="asked between-slide">
          <h3>{words.way}</h3>
          <div class="between-part">
            <AskedText
              label={words.part}
              symbol="t"
              text={part}
              problem={problemOf("part")}
              onInput={move}
            />
            <div class="between-slider">
              <var>p</var>
              <input
                type="range"
                min={0}
                max={1}
                step={0.01}
                aria-label={words.part}
                value={report?.part ?? 0}
                onInput={({ currentTarget }) => move(currentTarget.value)}
              />
              <var>q</var>
            </div>
          </div>
        </div>
        <div class="between-picture">
          {report && <BetweenPicture store={store} report={report} />}
        </div>
        {report && (
          <div class={`asked between-rows ${old}`}>
            <div>
              <Way store={store} report={report} of="way" />
              <Way store={store} report={report} of="halfway" />
            </div>
          </div>
        )}
        <div class="asked between-rate">
          <h3>{words.rate}</h3>
          <div class="between-part">
            <AskedText
              label={words.duration}
              symbol={words.within}
              text={within}
              problem={problemOf("duration")}
              onInput={(within) => store.set({ within }, { as: "within" })}
            />
            {within === "" && <p class="asked-lead">{words.rateLead}</p>}
          </div>
          {report?.rate && (
            <div class={old}>
              <Rate store={store} report={report} rate={report.rate} />
            </div>
          )}
        </div>
      </div>
    </section>
  );
}

/** Nearer than numbers with six decimals tell. */
const isHalfTurn = ({ local }: BetweenReport) => local.angleDeg > 179.9999;

function sentenceOf(store: Store, { verdict, local, p, q }: BetweenReport): string {
  const apart = shownRoughAngle(local.angleDeg, store.state.value.unit);
  const areMatrices = p.form.kind === "matrix" && q.form.kind === "matrix";
  return words.verdict(verdict, local.angleDeg === 0 ? undefined : apart, areMatrices);
}

function Differences({ store, report }: { store: Store; report: BetweenReport }) {
  const { digits, unit } = store.state.value;
  const { local, pEuler } = report;
  const angles = report.eulerDifferencesDeg.map((degrees) =>
    unit === "degrees" ? degrees : fromDegrees(degrees).radians,
  );
  const { quaternionDistance, negatedQuaternionDistance } = report;
  return (
    <div class="asked-columns">
      <div>
        <h3>{words.turn}</h3>
        {sides.map((axes) => {
          const { axis, angleDeg: degrees, angleRad: radians, rotationVectorRad } = report[axes];
          const angle = shownAngle({ degrees, radians }, digits, unit);
          return (
            <ArrayRow
              key={axes}
              name={words.turnOn[axes]}
              symbol={words.turnOn[axes]}
              numbers={rotationVectorRad}
              digits={digits}
              note={axis && words.turnAbout(angle, shownAxis(axis, digits))}
              value={{ kind: "rotation-vector", vectorRad: rotationVectorRad }}
            />
          );
        })}
        <h3>{words.error[report.declared.convention.perturbation]}</h3>
        {(["hamilton", "jpl"] as const).map((preset) => {
          const column = report[preset];
          return (
            <ArrayRow
              key={preset}
              name={words.errorIn(wordsOf[preset].name)}
              symbol={words.errorOf(preset === "hamilton" ? "⊙" : "⊗", column.rules.increment)}
              numbers={column.quaternion.array}
              digits={digits}
              note={`${wordsOf[preset].name} ${wordsOf[preset].order}`}
              value={columnValues(column, store.engine.describe).quaternion}
            />
          );
        })}
      </div>
      <div>
        <h3>{words.distances}</h3>
        <ScalarRow
          store={store}
          name={words.geodesic}
          number={unit === "degrees" ? local.angleDeg : local.angleRad}
          words={shownAngle(fromRadians(local.angleRad), digits, unit)}
        />
        <ScalarRow store={store} name={words.chordal} number={report.chordalDistance} />
        <ScalarRow
          store={store}
          name="‖p − q‖"
          number={quaternionDistance}
          {...(quaternionDistance <= negatedQuaternionDistance && { note: words.nearer("q") })}
        />
        <ScalarRow
          store={store}
          name="‖p + q‖"
          number={negatedQuaternionDistance}
          {...(quaternionDistance > negatedQuaternionDistance && { note: words.nearer("−q") })}
        />
        <h3>{words.euler(sequenceName(pEuler.sequence))}</h3>
        <ArrayRow
          name={words.eulerDifference}
          symbol={words.eulerDifference}
          numbers={angles}
          digits={digits}
          note={words.noTurn(unit)}
          value={{
            kind: "vector",
            symbol: "de",
            numbers: angles,
            on: words.copies.differences(sequenceName(pEuler.sequence), unit),
          }}
        />
      </div>
    </div>
  );
}

function Rate({ store, report, rate }: { store: Store; report: BetweenReport; rate: RateBetween }) {
  const { digits, unit } = store.state.value;
  const perSecond = shownAngle(fromRadians(report.local.angleRad / rate.durationS), digits, unit);
  const off = rate.mistakes.find(({ angleDeg }) => angleDeg > 0);
  return (
    <>
      {sides.map((axes) => {
        const { axis } = report[axes];
        return (
          <ArrayRow
            key={axes}
            name={words.rateOn[axes]}
            symbol={words.rateOn[axes]}
            numbers={rate[axes === "local" ? "bodyRad" : "worldRad"]}
            value={{
              kind: "vector",
              symbol: "omega",
              numbers: rate[axes === "local" ? "bodyRad" : "worldRad"],
              on: words.copies.rate[axes],
            }}
            digits={digits}
            note={axis && words.rateAbout(perSecond, shownAxis(axis, digits))}
          />
        );
      })}
      {off && <p class="asked-lead">{words.halfForgotten(shownRoughAngle(off.angleDeg, unit))}</p>}
    </>
  );
}

function Way({
  store,
  report,
  of,
}: {
  store: Store;
  report: BetweenReport;
  of: "way" | "halfway";
}) {
  const column = report[of];
  const name =
    of === "way"
      ? words.at(shown(report.part, store.state.value.digits))
      : words.halfway(isHalfTurn(report));
  return (
    <ArrayRow
      name={name}
      symbol={name}
      numbers={column.unit.array}
      digits={store.state.value.digits}
      value={columnValues(column, store.engine.describe).unit}
    />
  );
}
