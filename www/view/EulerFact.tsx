// The attitude as Euler angles in a sequence of one's choice.
import { type Digits, eulerAxes, sequenceName } from "../address.ts";
import { eulerValue } from "../copy/values.ts";
import type { Euler, EulerAxes, EulerFrame, EulerSequence } from "../engine.ts";
import { exactArray, shownArray, shownDegrees } from "../format.ts";
import type { Store } from "../state.ts";
import { fieldWords } from "../words/edit.ts";
import { Copy } from "./Copy.tsx";
import { NumberField } from "./NumberField.tsx";
import { numberGroup } from "./number_group.ts";

const frames: Record<EulerFrame, string> = {
  intrinsic: "about the moving axes (intrinsic)",
  extrinsic: "about the fixed axes (extrinsic)",
};

/** What the angles of the two customary sequences are called; of others, their axes. */
export function angleNames(sequence: EulerSequence): string[] {
  const name = sequenceName(sequence);
  if (name === "ZYX") return ["yaw", "pitch", "roll"];
  if (name === "xyz") return ["roll", "pitch", "yaw"];
  const [first = "", second = "", third = ""] = sequence.axes;
  return [`first, ${first}`, `second, ${second}`, `third, ${third}`];
}

export function EulerFact({
  euler,
  store,
  digits,
}: {
  euler: Euler;
  store: Store;
  digits: Digits;
}) {
  const chosen = store.state.value.euler;
  const names = angleNames(euler.sequence);
  const group = numberGroup(
    {
      store,
      id: "Euler angles",
      describe: () => ({ kind: "euler-angles", sequence: euler.sequence, unit: "degrees" }),
    },
    euler.anglesDeg,
  );
  return (
    <div class="fact fact-euler">
      <h2>Euler angles</h2>
      <div class="euler-choice">
        <select
          aria-label="Euler axes"
          value={chosen.axes}
          onChange={(event) =>
            store.set({ euler: { ...chosen, axes: event.currentTarget.value as EulerAxes } })
          }
        >
          {eulerAxes.map((axes) => (
            <option key={axes} value={axes}>
              {axes.split("").join("-")}
            </option>
          ))}
        </select>
        <select
          aria-label="Axes of the turns"
          value={chosen.frame}
          onChange={(event) =>
            store.set({ euler: { ...chosen, frame: event.currentTarget.value as EulerFrame } })
          }
        >
          {Object.entries(frames).map(([frame, words]) => (
            <option key={frame} value={frame}>
              {words}
            </option>
          ))}
        </select>
      </div>
      <div class="fact-value">
        <dl class="euler-angles">
          {names.map((name, at) => (
            <div key={at}>
              <dt>{name}</dt>
              <dd class="with-unit">
                <NumberField
                  group={group}
                  at={at}
                  label={fieldWords.eulerAngle(name, fieldWords.degrees)}
                  digits={digits}
                  unit="degrees"
                />
                °
              </dd>
            </div>
          ))}
        </dl>
        <Copy
          of="Euler angles in degrees"
          text={exactArray(euler.anglesDeg)}
          value={eulerValue(euler)}
        />
      </div>
      <p>
        <code>{shownArray(euler.anglesRad, digits)}</code> rad
        <Copy
          of="Euler angles in radians"
          text={exactArray(euler.anglesRad)}
          value={eulerValue(euler)}
        />
      </p>
      <GimbalLock euler={euler} names={names} digits={digits} />
    </div>
  );
}

function GimbalLock({ euler, names, digits }: { euler: Euler; names: string[]; digits: Digits }) {
  const lock = euler.gimbalLock;
  if (lock === undefined) return null;
  const sign = lock.survivor === "sum" ? "+" : "−";
  return (
    <p class="gimbal-lock">
      <strong>Gimbal lock</strong>: the outer axes are one line, and only {names[0]} {sign}{" "}
      {names[2]} = <code>{shownDegrees(lock.survivorDeg, digits)}</code> is determined;{" "}
      {names[lock.lost]} is set to 0.
    </p>
  );
}
