// The picture of the Compose view: the same two turns about fixed and about moving axes, step by step.
import { useId, useRef } from "preact/hooks";
import type { ComposeReport, Handedness, Operand, Turn } from "../engine.ts";
import type { Unit } from "../model/page_state.ts";
import type { Step } from "../model/picture_state.ts";
import { shownAxis, shownRoughAngle } from "../number/format.ts";
import type { Freshness, Store } from "../state/store.ts";
import { pictureWords, stepWords as words } from "../words/picture.ts";
import { cameraOf } from "./camera.ts";
import { type Axes, composeScene, type Stage as Made, stagesOf } from "./compose_scene.ts";
import { useMotion } from "./motion.ts";
import { Stage } from "./Stage.tsx";
import { saveFile, svgText } from "./save.ts";
import "./compose_picture.css";

export function ComposePicture({ store }: { store: Store }) {
  const shown = store.compose.value;
  return shown ? <Steps store={store} {...shown} /> : null;
}

const allSteps: readonly Step[] = [0, 1, 2];
const signs: Record<Handedness, string> = { right: "⊙", left: "⊗" };
const angleOf = ({ angleDeg }: Turn, unit: Unit) => shownRoughAngle(angleDeg, unit, 4);

function Steps({
  store,
  report,
  freshness,
}: {
  store: Store;
  report: ComposeReport;
  freshness: Freshness;
}) {
  const { step } = store.state.value.picture;
  const motion = useMotion();
  const group = useId();
  const goTo = (next: Step, atEnd?: () => void) => {
    const { picture } = store.state.peek();
    store.set({ picture: { ...picture, step: next } });
    if (next === 0 || (next !== picture.step + 1 && atEnd === undefined)) atEnd?.();
    else motion.start(atEnd);
  };
  const play = () => {
    goTo(0);
    goTo(1, () => goTo(2));
  };
  const { left, right, convention } = report.declared;
  return (
    <>
      <div class="steps-head">
        <h2>{words.name}</h2>
        <p>{words.end(`${left} ${signs[convention.handedness]} ${right}`)}</p>
        <div class="steps-choice">
          <fieldset class="choice">
            <legend class="visually-hidden">{words.name}</legend>
            {allSteps.map((each) => (
              <label key={each}>
                <input
                  type="radio"
                  name={group}
                  value={each}
                  checked={each === step}
                  onChange={() => goTo(each)}
                />
                <span>{words.steps[each]}</span>
              </label>
            ))}
          </fieldset>
          <button type="button" class="text-button" onClick={play}>
            {words.play}
          </button>
        </div>
      </div>
      <div class={`steps-pair ${freshness === "current" ? "" : "picture-old"}`}>
        {(["fixed", "moving"] as const).map((axes) => (
          <Way
            key={axes}
            store={store}
            axes={axes}
            stages={stagesOf(report, axes)}
            step={step}
            part={motion.progress}
          />
        ))}
      </div>
    </>
  );
}

function Way({
  store,
  axes,
  stages,
  step,
  part,
}: {
  store: Store;
  axes: Axes;
  stages: readonly [Made, Made];
  step: Step;
  part: number;
}) {
  const frame = useRef<HTMLDivElement>(null);
  const describedBy = useId();
  const { picture, unit } = store.state.value;
  const { look } = picture;
  const angleLabel = (operand: Operand, turn: Turn) => `${operand}: ${angleOf(turn, unit)}`;
  const scene = composeScene(stages, axes, step, part, cameraOf(look), angleLabel);
  const made = stages.slice(0, step).map((stage) => said(stage, axes, unit));
  const description = made.length === 0 ? words.start : made.join(" ");
  const [first, then] = stages;
  const title = words.about[axes](first.operand, then.operand);
  const save = () => {
    const stage = frame.current?.querySelector<SVGSVGElement>(".stage svg");
    if (stage) saveFile(words.fileName[axes], svgText(stage, title, description));
  };
  return (
    <div ref={frame} class="steps-way">
      <div class="steps-way-head">
        <h3>{title}</h3>
        <button type="button" class="text-button" onClick={save}>
          {pictureWords.save}
        </button>
      </div>
      <Stage
        scene={scene}
        look={look}
        label={words.label[axes]}
        describedBy={describedBy}
        onLook={(turned) => store.set({ picture: { ...store.state.peek().picture, look: turned } })}
      />
      <p class="picture-says" id={describedBy}>
        {description}
        <span class="visually-hidden"> {pictureWords.lookOnly}</span>
      </p>
    </div>
  );
}

/** What was turned, about which axis of which frame. */
function said({ operand, turn }: Made, axes: Axes, unit: Unit): string {
  if (turn.axis === undefined) return words.noTurn(operand);
  return words.turned[axes](operand, angleOf(turn, unit), shownAxis(turn.axis, "4"));
}
