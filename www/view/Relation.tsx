// How the two readings relate: two true sentences that must not be mixed up.
import type { Digits, Preset } from "../address.ts";
import type { ReadReport } from "../engine.ts";
import { shownArray } from "../format.ts";
import { operatorOf } from "./words.ts";

export function Relation({
  report,
  digits,
  declared,
}: {
  report: ReadReport;
  digits: Digits;
  declared: Preset | undefined;
}) {
  const { handedness, ...declaration } = report.quaternion.convention;
  const isEq18 = handedness === "left" && operatorOf(declaration) === "body-to-world";
  const array = (numbers: readonly number[]) => <code>{shownArray(numbers, digits)}</code>;
  return (
    <section class="relation" aria-label="How the two readings relate">
      <div class="relation-part applies">
        <h2>Same numbers, transposed matrices</h2>
        <p>
          <var>C</var>(<var>q</var>) = <var>R</var>(<var>q</var>)<sup>T</sup>. Hamilton leads from
          body to world and JPL from world to body, so both say the same attitude:{" "}
          <strong>nothing is conjugated</strong>, only the order of the numbers changes.
        </p>
        <dl class="relation-numbers">
          <dt class="hamilton">Hamilton, body → world</dt>
          <dd>{array(report.hamilton.quaternion.array)}</dd>
          <dt class="jpl">JPL, world → body</dt>
          <dd>{array(report.jpl.quaternion.array)}</dd>
        </dl>
        <p class="relation-applies">{applies(declared)}</p>
      </div>
      <div class="relation-part">
        <h2>Same matrix, conjugate numbers</h2>
        <p>
          If a JPL program states the direction body to world, its matrix <var>C</var> is this{" "}
          <var>R</var>(<var>q</var>), and its vector part has the <strong>other sign</strong>{" "}
          <span class="source">(Yoosefian 2021, eq. 18)</span>.
        </p>
        <dl class="relation-numbers">
          <dt class="hamilton">Hamilton, body → world</dt>
          <dd>{array(report.hamilton.quaternion.array)}</dd>
          <dt class="jpl">JPL, body → world</dt>
          <dd>{array(report.jplWithSameMatrix.array)}</dd>
        </dl>
        <p class="relation-applies">
          {isEq18 ? "This is what you declared." : appliesNot(declared)}
        </p>
      </div>
    </section>
  );
}

function applies(declared: Preset | undefined): string {
  if (declared === undefined) return "Applies between two programs that keep these customs.";
  return declared === "hamilton"
    ? "Applies to you if the JPL side keeps its custom, world to body."
    : "Applies to you if the Hamilton side keeps its custom, body to world.";
}

function appliesNot(declared: Preset | undefined): string {
  return declared === "jpl"
    ? "Not what you declared: your JPL numbers lead from world to body."
    : "Not what you declared: only for a JPL side that states body to world.";
}
