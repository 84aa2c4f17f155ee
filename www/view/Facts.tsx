// What no convention changes: the turn itself.
import type { ReadReport } from "../engine.ts";
import { exact, exactArray, shownAngle, shownArray, shownAxis } from "../format.ts";
import type { Store } from "../state.ts";
import { Copy } from "./Copy.tsx";
import { EulerFact } from "./EulerFact.tsx";

export function Facts({ report, store }: { report: ReadReport; store: Store }) {
  const { digits, unit } = store.state.value;
  const { angleDeg, angleRad, axis, rotationVectorRad } = report.turn;
  const angle = { degrees: angleDeg, radians: angleRad };
  const opposite = report.hamilton.quaternion.array.map((number) => 0 - number);
  return (
    <section class="facts" aria-label="The turn, in every convention the same">
      <div class="fact">
        <h2>Axis and angle</h2>
        <p class="fact-value">
          <code>
            {axis === undefined ? "no turn, no axis" : shownAxis(axis, digits)}
            {axis !== undefined && `, ${shownAngle(angle, digits, unit)}`}
          </code>
          {axis !== undefined && (
            <Copy of="axis and angle in radians" text={`${exactArray(axis)}, ${exact(angleRad)}`} />
          )}
        </p>
        <p>
          <code>{shownAngle(angle, digits, unit === "degrees" ? "radians" : "degrees")}</code>.
          Carries the world axes onto the body axes, right-handed.
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
        <h2>The other sign</h2>
        <p class="fact-value">
          <code>{shownArray(opposite, digits)}</code>
          <Copy of="minus q" text={exactArray(opposite)} />
        </p>
        <p>
          −<var>q</var>, as <code>w x y z</code>: the same rotation, not its inverse.
        </p>
      </div>
    </section>
  );
}
