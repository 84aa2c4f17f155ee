// By how much a translation is wrong that makes one of the usual mistakes.
import type { TranslateReport } from "../../engine.ts";
import type { Digits, Unit } from "../../model/page_state.ts";
import { fromDegrees, shownAngle } from "../../number/format.ts";
import { mistakeOf, none, off, title } from "../../words/translate/mistakes_card.tsx";
import "../parts/result.css";
import "./mistakes_card.css";

/** The angle by which the attitude is wrong. */
export function MistakesCard({
  report,
  digits,
  unit,
}: {
  report: TranslateReport;
  digits: Digits;
  unit: Unit;
}) {
  const mistakes = report.mistakes.map(({ kind, angleDeg }) => ({
    words: mistakeOf(kind, report.change),
    angleDeg,
  }));
  return (
    <section class="fact mistakes" aria-labelledby="mistakes-name">
      <h2 id="mistakes-name">{title}</h2>
      <ul>
        {mistakes.map(({ words, angleDeg }) => (
          <li key={words}>
            <span class="mistake-words">{words}</span>
            {angleDeg === 0 ? (
              <span class="mistake-none">{none}</span>
            ) : (
              <>
                <span class="mistake-angle">
                  {off(<code>{shownAngle(fromDegrees(angleDeg), digits, unit)}</code>)}
                </span>
                <span class="mistake-bar" aria-hidden="true">
                  <span style={{ width: `${(angleDeg / 180) * 100}%` }} />
                </span>
              </>
            )}
          </li>
        ))}
      </ul>
    </section>
  );
}
