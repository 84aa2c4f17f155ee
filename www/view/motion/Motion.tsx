// The Motion view: one attitude, a small turn, a rate, and where that leads in time.
import type { MotionReport } from "../../engine.ts";
import { declaredConvention } from "../../model/conventions.ts";
import { type Choices, choicesOf, mostSteps, textOf } from "../../model/motion_choices.ts";
import { shownRoughAngle } from "../../number/format.ts";
import type { Store } from "../../state/store.ts";
import * as words from "../../words/motion/motion.tsx";
import { AskStatus } from "../parts/Ask.tsx";
import { AskedFold } from "../parts/AskedFold.tsx";
import { ConventionSwitch } from "../parts/ConventionSwitch.tsx";
import { MoreAxes } from "../parts/MoreAxes.tsx";
import { Notes } from "../parts/Notes.tsx";
import { NumberSettings } from "../parts/NumberSettings.tsx";
import { Picture } from "../parts/Picture.tsx";
import { SettingChoice } from "../parts/SettingChoice.tsx";
import { TextField } from "../parts/TextField.tsx";
import { UndoRedo } from "../parts/UndoRedo.tsx";
import { DerivativeCard } from "./DerivativeCard.tsx";
import { IncrementCard } from "./IncrementCard.tsx";
import { PathCard } from "./PathCard.tsx";
import "../parts/fold.css";
import "../parts/result.css";
import "./motion.css";

export { askedOfMotion } from "./asked.ts";

const loadCovariance = () => import("./OfVectors.tsx").then(({ Covariance }) => Covariance);
const loadPoint = () => import("./OfVectors.tsx").then(({ Point }) => Point);

export function Motion({ store }: { store: Store }) {
  const shownResult = store.motion.value;
  const choices = choicesOf(store.state.value);
  const choose = (chosen: Partial<Choices>) =>
    store.set({ motion: textOf({ ...choicesOf(store.state.peek()), ...chosen }) });
  return (
    <>
      <section class="ask" aria-label={words.input}>
        <div class="ask-row">
          <TextField store={store} field="quaternion">
            <UndoRedo store={store} />
          </TextField>
          <ConventionSwitch store={store} />
        </div>
        <div class="motion-texts">
          <TextField store={store} field="rate" label={words.fields.rate} />
          <span>{words.to}</span>
          <TextField store={store} field="rate-end" name="rateEnd" label={words.fields.rateEnd} />
          <span>{words.within}</span>
          <TextField store={store} field="duration" label={words.fields.duration} />
          <TextField store={store} field="increment" label={words.fields.increment} />
        </div>
        <div class="motion-settings">
          <SettingChoice
            name="rate-axes"
            label={words.axesName}
            choices={["body", "world"]}
            chosen={choices.rateAxes}
            words={words.axesWords}
            onChoose={(rateAxes) => choose({ rateAxes })}
          />
          <SettingChoice
            name="increment-sign"
            label={words.signName}
            choices={["physical", "formal"]}
            chosen={choices.incrementSign}
            words={words.signWords}
            onChoose={(incrementSign) => choose({ incrementSign })}
          />
          <label class="motion-steps">
            {words.stepsName}{" "}
            <input
              type="number"
              min={1}
              max={mostSteps}
              value={choices.steps}
              onChange={({ currentTarget }) => {
                const steps = Math.min(
                  mostSteps,
                  Math.max(1, Math.round(currentTarget.valueAsNumber || 1)),
                );
                currentTarget.value = String(steps);
                choose({ steps, moment: steps });
              }}
            />
          </label>
          <NumberSettings store={store} />
        </div>
        <MoreAxes store={store} />
        <AskStatus store={store} freshness={shownResult?.freshness}>
          <div class="read-as">
            <p>
              {words.units(
                words.axesWords[
                  declaredConvention(store.state.value).perturbation === "local" ? "body" : "world"
                ],
              )}
            </p>
            {shownResult && <Notes notes={shownResult.report.notes} store={store} />}
          </div>
        </AskStatus>
      </section>
      {shownResult && (
        <div class={`result motion ${shownResult.freshness}`}>
          <Result store={store} report={shownResult.report} />
        </div>
      )}
    </>
  );
}

function Result({ store, report }: { store: Store; report: MotionReport }) {
  const { increment, derivative, path } = report;
  const cards = {
    path: path && <PathCard store={store} path={path} report={report} />,
    increment: increment && <IncrementCard store={store} increment={increment} />,
    derivative: derivative && <DerivativeCard store={store} derivative={derivative} />,
  };
  const card = (name: keyof typeof cards) => (
    <section class="card" aria-labelledby={`motion-${name}`}>
      <h2 id={`motion-${name}`}>{words.names[name]}</h2>
      {cards[name] ?? <p class="motion-soft">{words.empty[name]}</p>}
    </section>
  );
  return (
    <>
      <div class="motion-cards">
        <Picture store={store} of="motion" />
        {card("increment")}
      </div>
      <div class="motion-cards">
        {card("path")}
        {card("derivative")}
      </div>
      <div class="folds motion-folds">
        <AskedFold
          store={store}
          name="covariance"
          summary={words.covarianceFold}
          load={loadCovariance}
        />
        <AskedFold store={store} name="point" summary={words.pointFold} load={loadPoint} />
      </div>
    </>
  );
}

/** What a screen reader hears when the result changes. */
export function spokenMotion(store: Store): string {
  const path = store.motion.value?.report.path;
  const { unit } = store.state.value;
  return path ? words.spoken(shownRoughAngle(path.turn.angleDeg, unit, 4)) : words.spokenStill;
}
