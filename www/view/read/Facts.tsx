// What no convention changes: the rotation itself.
import { negates } from "../../action/fixes.ts";
import { turnValues } from "../../copy/values.ts";
import type { ReadReport } from "../../engine.ts";
import type { Digits } from "../../model/page_state.ts";
import { exact, exactArray, inDegrees, shownAngle, shownArray } from "../../number/format.ts";
import type { Store } from "../../state/store.ts";
import { otherSign } from "../../words/parts/notes.tsx";
import { fieldWords } from "../../words/parts/number_field.ts";
import * as words from "../../words/read/facts.ts";
import { Copy } from "../parts/Copy.tsx";
import { FixButton, NoteOfTurn } from "../parts/Notes.tsx";
import { NumberField } from "../parts/NumberField.tsx";
import { type NumberGroup, numberGroup } from "../parts/number_group.ts";
import { EulerFact } from "./EulerFact.tsx";
import "../parts/result.css";
import "./facts.css";

/** Stands for the axis where there is no turn, as about every other one. */
const anyAxis = [0, 0, 1] as const;

export function Facts({ report, store }: { report: ReadReport; store: Store }) {
  const { digits, unit } = store.state.value;
  const { angleDeg, angleRad, axis, rotationVectorRad } = report.turn;
  const angle = { degrees: angleDeg, radians: angleRad };
  const turn = numberGroup(
    { store, id: "axis-and-angle", describe: () => ({ kind: "axis-angle", unit }) },
    [unit === "degrees" ? inDegrees(angleDeg) : angleRad, ...(axis ?? anyAxis)],
  );
  const rotationVector = numberGroup(
    { store, id: "rotation-vector", describe: () => ({ kind: "rotation-vector" }) },
    rotationVectorRad,
  );
  const values = turnValues(report, store.engine.describe);
  const opposite = report.hamilton.quaternion.array.map((number) => 0 - number);
  return (
    <section class="facts" aria-label={words.facts}>
      <div class="fact">
        <header>
          <h2>{words.axisAndAngle}</h2>
          <code>{shownAngle(angle, digits, unit === "degrees" ? "radians" : "degrees")}</code>
          {axis !== undefined && (
            <Copy
              of={words.axisAndAngleInRadians}
              text={`${exactArray(axis)}, ${exact(angleRad)}`}
              value={values.axisAngle}
            />
          )}
        </header>
        <p class="fact-value numbers">
          <span class="with-unit">
            <NumberField
              group={turn}
              at={0}
              label={fieldWords.angleIn(fieldWords[unit])}
              digits={digits}
              unit={unit}
            />
            {unit === "degrees" ? "°" : "\u00a0rad"}
          </span>
          <span class="about">{fieldWords.about}</span>
          <VectorFields group={turn} first={1} label={fieldWords.axis} digits={digits} />
        </p>
        <NoteOfTurn notes={report.notes} store={store} />
      </div>
      <div class="fact">
        <header>
          <h2>{words.rotationVector}</h2>
          <Copy
            of={words.rotationVectorCopied}
            text={exactArray(rotationVectorRad)}
            value={values.rotationVector}
          />
        </header>
        <p class="fact-value numbers">
          <VectorFields
            group={rotationVector}
            first={0}
            label={fieldWords.rotationVector}
            digits={digits}
          />
        </p>
        <p>{words.rotationVectorNote}</p>
      </div>
      <EulerFact euler={report.euler} store={store} digits={digits} />
      <div class="fact">
        <header>
          <h2>{otherSign.heading}</h2>
          <FixButton
            store={store}
            field="quaternion"
            fix={negates(store, "quaternion", "quaternion")}
          />
          <Copy of={words.oppositeCopied} text={exactArray(opposite)} value={values.opposite} />
        </header>
        <p class="fact-value">
          <code>{shownArray(opposite, digits)}</code>
        </p>
        <p>{otherSign.words}</p>
      </div>
    </section>
  );
}

/** Three coordinates in brackets: those of the group from `first` on. */
function VectorFields({
  group,
  first,
  label,
  digits,
}: {
  group: NumberGroup;
  first: number;
  label: (name: string) => string;
  digits: Digits;
}) {
  return (
    <span class="vector">
      {["x", "y", "z"].map((name, at) => (
        <NumberField key={name} group={group} at={first + at} label={label(name)} digits={digits} />
      ))}
    </span>
  );
}
