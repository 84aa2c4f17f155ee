// How the two readings relate: two true sentences that must not be mixed up; and the order of products.
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
  return (
    <section class="relation" aria-label={words.title}>
      <p>
        <strong>{words.sameNumbers}</strong> {words.sameNumbersSays}{" "}
        <span class="relation-applies">{words.applies(declared)}</span>
      </p>
      <p>
        <strong>{words.sameMatrix}</strong>{" "}
        {words.sameMatrixSays(<code>{shownArray(report.jplWithSameMatrix.array, digits)}</code>)}{" "}
        <span class="relation-applies">{isEq18 ? words.declared : words.declaredNot}</span>
      </p>
      <p class="relation-order">
        <strong>{words.order}</strong> {words.orderSays}
      </p>
    </section>
  );
}
