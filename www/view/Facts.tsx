// What no convention changes: the turn itself.
import type { ReadReport } from "../engine.ts";
import { negates } from "../fixes.ts";
import { exact, exactArray, shown, shownArray, shownAxis, shownDegrees } from "../format.ts";
import type { Store } from "../state.ts";
import { otherSign } from "../words/notes.tsx";
import { Copy } from "./Copy.tsx";
import { EulerFact } from "./EulerFact.tsx";
import { FixButton, NoteOfTurn } from "./Notes.tsx";

export function Facts({ report, store }: { report: ReadReport; store: Store }) {
  const { digits } = store.state.value;
  const { angleDeg, angleRad, axis, rotationVectorRad } = report.turn;
  const opposite = report.hamilton.quaternion.array.map((number) => 0 - number);
  return (
    <section class="facts" aria-label="The turn, in every convention the same">
      <div class="fact">
        <h2>Axis and angle</h2>
        <p class="fact-value">
          <code>
            {axis === undefined ? "no turn, no axis" : shownAxis(axis, digits)}
            {axis !== undefined && `, ${shownDegrees(angleDeg, digits)}`}
          </code>
          {axis !== undefined && (
            <Copy of="axis and angle in radians" text={`${exactArray(axis)}, ${exact(angleRad)}`} />
          )}
        </p>
        <p>
          <code>{shown(angleRad, digits)}</code> rad.{" "}
          <NoteOfTurn notes={report.notes} store={store}>
            Carries the world axes onto the body axes, right-handed.
          </NoteOfTurn>
        </p>
      </div>
      <div class="fact">
        <h2>Rotation vector</h2>
        <p class="fact-value">
          <code>{shownArray(rotationVectorRad, digits)}</code>
          <Copy of="rotation vector" text={exactArray(rotationVectorRad)} />
        </p>
        <p>Angle times axis, in radians. No convention changes it.</p>
      </div>
      <EulerFact euler={report.euler} store={store} digits={digits} />
      <div class="fact">
        <h2>{otherSign.heading}</h2>
        <p class="fact-value">
          <code>{shownArray(opposite, digits)}</code>
          <Copy of="minus q" text={exactArray(opposite)} />
        </p>
        <p>
          {otherSign.words}
          <FixButton
            store={store}
            field="quaternion"
            fix={negates(store, "quaternion", "quaternion")}
          />
        </p>
      </div>
    </section>
  );
}
