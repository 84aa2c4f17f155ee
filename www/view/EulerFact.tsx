// The attitude as Euler angles in a sequence of one's choice.
import { type Digits, eulerAxes, sequenceName } from "../address.ts";
import type { Euler, EulerAxes, EulerFrame, EulerSequence } from "../engine.ts";
import { exactArray, shownArray, shownDegrees } from "../format.ts";
import type { Store } from "../state.ts";
import { gimbalLockWords, nearLockWords } from "../words/notes.tsx";
import { Copy } from "./Copy.tsx";

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
          {euler.anglesDeg.map((angle, at) => (
            <div key={names[at]}>
              <dt>{names[at]}</dt>
              <dd>
                <code>{shownDegrees(angle, digits)}</code>
              </dd>
            </div>
          ))}
        </dl>
        <Copy of="Euler angles in degrees" text={exactArray(euler.anglesDeg)} />
      </div>
      <p>
        <code>{shownArray(euler.anglesRad, digits)}</code> rad
        <Copy of="Euler angles in radians" text={exactArray(euler.anglesRad)} />
      </p>
      <GimbalLock euler={euler} names={names} digits={digits} />
    </div>
  );
}

/** Nearer to the lock than this is the rounding of 90° to a double, which is no distance. */
const roundingDeg = 1e-12;

function GimbalLock({ euler, names, digits }: { euler: Euler; names: string[]; digits: Digits }) {
  const { gimbalLock: lock, nearLockDeg } = euler;
  if (nearLockDeg !== undefined) return <p class="gimbal-lock">{nearLockWords(nearLockDeg)}</p>;
  if (lock === undefined) return null;
  const sign = lock.survivor === "sum" ? "+" : "−";
  return (
    <p class="gimbal-lock">
      {gimbalLockWords({
        names,
        sign,
        survivor: shownDegrees(lock.survivorDeg, digits),
        lost: names[lock.lost],
        distance:
          lock.distanceDeg < roundingDeg ? undefined : shownDegrees(lock.distanceDeg, digits),
      })}
    </p>
  );
}
