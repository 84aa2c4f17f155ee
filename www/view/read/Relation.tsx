// How the two readings relate: two true sentences that must not be mixed up.
import type { ReadReport } from "../../engine.ts";
import type { Digits, Preset } from "../../model/page_state.ts";
import { shownArray } from "../../number/format.ts";
import * as words from "../../words/read/relation.tsx";
import "./relation.css";

export function Relation({
  report,
  digits,
  declared,
}: {
  report: ReadReport;
  digits: Digits;
  declared: Preset | undefined;
}) {
  const { handedness } = report.quaternion.convention;
  const isEq18 = handedness === "left" && report.rules.operator === "body-to-world";
  const array = (numbers: readonly number[]) => <code>{shownArray(numbers, digits)}</code>;
  return (
    <section class="relation" aria-label={words.title}>
      <div class="relation-part applies">
        <h2>{words.sameNumbers}</h2>
        <p>{words.sameNumbersSays}</p>
        <dl class="relation-numbers">
          <dt class="hamilton">{words.hamilton}</dt>
          <dd>{array(report.hamilton.quaternion.array)}</dd>
          <dt class="jpl">{words.jpl}</dt>
          <dd>{array(report.jpl.quaternion.array)}</dd>
        </dl>
        <p class="relation-applies">{words.applies(declared)}</p>
      </div>
      <div class="relation-part">
        <h2>{words.sameMatrix}</h2>
        <p>{words.sameMatrixSays}</p>
        <dl class="relation-numbers">
          <dt class="hamilton">{words.hamilton}</dt>
          <dd>{array(report.hamilton.quaternion.array)}</dd>
          <dt class="jpl">{words.jplBodyToWorld}</dt>
          <dd>{array(report.jplWithSameMatrix.array)}</dd>
        </dl>
        <p class="relation-applies">{isEq18 ? words.declared : words.appliesNot(declared)}</p>
      </div>
    </section>
  );
}
