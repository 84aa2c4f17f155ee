// What is done to four numbers on the way, and why, with the frames.
import type { CosineMatrix, TranslatedEnd, TranslateReport } from "../../engine.ts";
import type { EndNames } from "../../words/translate/translate.ts";
import * as words from "../../words/translate/why.tsx";

export function Why({ report, names }: { report: TranslateReport; names: EndNames }) {
  const { from, to } = report;
  return (
    <div class="why">
      <p>
        {words.sentence({
          isAssumed: [from, to].some(({ assumed }) => assumed.includes("action")),
          frames: <Frames from={from} to={to} names={names} />,
          isConjugated: isConjugated(report),
          order: orderWords(from, to),
          hasAxes: report.axes !== undefined,
        })}
      </p>
    </div>
  );
}

const isConjugated = ({ change }: TranslateReport) =>
  change === "conjugated" || change === "reordered-and-conjugated";

/** The sentence that decides about the conjugate. */
function Frames({ from, to, names }: { from: TranslatedEnd; to: TranslatedEnd; names: EndNames }) {
  const sameAction = from.action === to.action;
  const sameDirection = from.direction === to.direction;
  const byFrom = <Of action={from.action} />;
  const byTo = <Of action={to.action} />;
  if (sameDirection) {
    return sameAction
      ? words.same(names, from.direction, byFrom)
      : words.transposed(names, from.direction, [byFrom, byTo]);
  }
  return (
    <>
      {words.each(names, [from.direction, to.direction], [byFrom, byTo])}
      {sameAction ? words.inverse : words.asAsked(<Of action="R" />, <Of action="C" />)}
    </>
  );
}

export function Of({ action }: { action: CosineMatrix }) {
  return (
    <>
      <var>{action}</var>(<var>q</var>)
    </>
  );
}

function orderWords(from: TranslatedEnd, to: TranslatedEnd): string {
  return from.order === to.order
    ? words.orderStays(to.order, to.constructorOrder)
    : words.scalarMoves[to.order];
}
