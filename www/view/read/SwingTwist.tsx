// One attitude as a rotation about an axis, and the rest.
import { quaternionValue } from "../../copy/values.ts";
import type { Components, Request, Turn } from "../../engine.ts";
import { declaredConvention } from "../../model/conventions.ts";
import type { PageState } from "../../model/page_state.ts";
import { fromRadians, shownAngle, shownAxis } from "../../number/format.ts";
import type { Store } from "../../state/store.ts";
import { lettersOf } from "../../words/conventions.ts";
import * as words from "../../words/read/swing_twist.ts";
import { AskedText, ScalarRow, useAsked } from "../parts/asked.tsx";
import { ArrayRow } from "../parts/Value.tsx";

export function askedOfSwingTwist(state: PageState): Request {
  const { quaternion, axis, matrix } = state;
  return { view: "swing-twist", quaternion, axis, convention: declaredConvention(state), matrix };
}

export function SwingTwist({ store }: { store: Store }) {
  const { report, problems, old } = useAsked(store, askedOfSwingTwist, "swing-twist");
  const { axis, digits, unit } = store.state.value;
  const angle = (radians: number) => shownAngle(fromRadians(radians), digits, unit);
  const turned = ({ angleRad, axis }: Turn) =>
    axis && words.turn(angle(angleRad), shownAxis(axis, digits));
  const row = (name: string, quaternion: Components, note: string | undefined) => (
    <ArrayRow
      name={name}
      symbol={name}
      numbers={quaternion.array}
      digits={digits}
      note={note}
      value={
        report &&
        quaternionValue("q", quaternion, report.quaternion.convention, store.engine.describe)
      }
    />
  );
  return (
    <section class="card asked" aria-label={words.title}>
      <AskedText
        label={words.axis}
        symbol={words.axis}
        text={axis}
        problem={problems.find(({ field }) => field === "axis")}
        onInput={(axis) => store.set({ axis })}
      />
      {report && (
        <div class={old}>
          {report.twistRad === undefined ? (
            <p class="asked-lead">{words.noTwist}</p>
          ) : (
            <ScalarRow
              store={store}
              name={words.angle}
              number={unit === "degrees" ? (report.twistDeg ?? 0) : report.twistRad}
              words={angle(report.twistRad)}
            />
          )}
          {row(words.twist, report.twist, lettersOf[report.quaternion.convention.order])}
          {row(words.swing, report.swingQuaternion, turned(report.swing))}
          {row(words.bodySwing, report.bodySwingQuaternion, turned(report.bodySwing))}
        </div>
      )}
    </section>
  );
}
