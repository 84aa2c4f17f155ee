// The attitude as Euler angles in a sequence of one's choice.
import { eulerValue } from "../../copy/values.ts";
import type { Euler, EulerAxes, EulerFrame, EulerSequence } from "../../engine.ts";
import { sequenceName } from "../../model/euler_sequence.ts";
import type { Digits, Unit } from "../../model/page_state.ts";
import { exactArray, fromDegrees, inDegrees, shownAngle } from "../../number/format.ts";
import type { Store } from "../../state/store.ts";
import { eulerAxesValues } from "../../values.ts";
import { gimbalLockWords, nearLockWords } from "../../words/parts/notes.tsx";
import { fieldWords } from "../../words/parts/number_field.ts";
import * as words from "../../words/read/facts.ts";
import { Copy } from "../parts/Copy.tsx";
import { NumberField } from "../parts/NumberField.tsx";
import { numberGroup } from "../parts/number_group.ts";
import "../parts/result.css";
import "./euler_fact.css";

const unitWords: Record<Unit, string> = { degrees: "°", radians: "\u00a0rad" };

/** What the angles of the two customary sequences are called; of others, their axes. */
export function angleNames(sequence: EulerSequence): string[] {
  const name = sequenceName(sequence);
  if (name === "ZYX") return words.yawPitchRoll;
  if (name === "xyz") return words.yawPitchRoll.toReversed();
  return words.ordinals([...sequence.axes]);
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
  const { euler: chosen, unit } = store.state.value;
  const copied = {
    degrees: { of: words.eulerCopied(fieldWords.degrees), text: exactArray(euler.anglesDeg) },
    radians: { of: words.eulerCopied(fieldWords.radians), text: exactArray(euler.anglesRad) },
  };
  const names = angleNames(euler.sequence);
  const group = numberGroup(
    {
      store,
      id: "euler-angles",
      describe: () => ({ kind: "euler-angles", sequence: euler.sequence, unit }),
    },
    unit === "degrees" ? euler.anglesDeg.map(inDegrees) : euler.anglesRad,
  );
  return (
    <div class="fact fact-euler">
      <header class="euler-choice">
        <h2>{words.eulerAngles}</h2>
        <select
          aria-label={words.eulerAxes}
          value={chosen.axes}
          onChange={(event) =>
            store.set({ euler: { ...chosen, axes: event.currentTarget.value as EulerAxes } })
          }
        >
          {eulerAxesValues.map((axes) => (
            <option key={axes} value={axes}>
              {axes.split("").join("-")}
            </option>
          ))}
        </select>
        <select
          aria-label={words.eulerFrame}
          value={chosen.frame}
          onChange={(event) =>
            store.set({ euler: { ...chosen, frame: event.currentTarget.value as EulerFrame } })
          }
        >
          {Object.entries(words.frames).map(([frame, name]) => (
            <option key={frame} value={frame}>
              {name}
            </option>
          ))}
        </select>
        <Copy {...copied[unit]} value={eulerValue(euler)} />
      </header>
      <div class="fact-value">
        <dl class="euler-angles">
          {names.map((name, at) => (
            <div key={at}>
              <dt>{name}</dt>
              <dd class="with-unit">
                <NumberField
                  group={group}
                  at={at}
                  label={fieldWords.eulerAngle(name, fieldWords[unit])}
                  digits={digits}
                  unit={unit}
                />
                {unitWords[unit]}
              </dd>
            </div>
          ))}
        </dl>
      </div>
      <GimbalLock euler={euler} names={names} digits={digits} unit={unit} />
      {euler.freeSequence && <FreeSequence sequence={euler.freeSequence} store={store} />}
    </div>
  );
}

/** A sequence that is far from its own lock, one click away. */
function FreeSequence({ sequence, store }: { sequence: EulerSequence; store: Store }) {
  const letters = [...sequence.axes].join("-");
  return (
    <p>
      {words.free}{" "}
      <button type="button" class="fix" onClick={() => store.set({ euler: sequence })}>
        <span class="fix-label">{words.showSequence(letters)}</span>
      </button>
    </p>
  );
}

/** Nearer to the lock than this is the rounding of 90° to a double, which is no distance. */
const roundingDeg = 1e-12;

function GimbalLock({
  euler,
  names,
  digits,
  unit,
}: {
  euler: Euler;
  names: string[];
  digits: Digits;
  unit: Unit;
}) {
  const { gimbalLock: lock, nearLockDeg } = euler;
  if (nearLockDeg !== undefined) {
    return <p class="gimbal-lock">{nearLockWords(nearLockDeg, unit)}</p>;
  }
  if (lock === undefined) return null;
  const sign = lock.survivor === "sum" ? "+" : "−";
  return (
    <p class="gimbal-lock">
      {gimbalLockWords({
        names,
        sign,
        survivor: shownAngle(fromDegrees(inDegrees(lock.survivorDeg)), digits, unit),
        lost: names[lock.lost],
        distance:
          lock.distanceDeg < roundingDeg
            ? undefined
            : shownAngle(fromDegrees(lock.distanceDeg), digits, unit),
      })}
    </p>
  );
}
