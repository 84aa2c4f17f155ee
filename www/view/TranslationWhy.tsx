// What is done to four numbers on the way, and why, with the frames.
import type { CosineMatrix, TranslatedEnd, TranslateReport } from "../engine.ts";
import { type EndNames, whyWords } from "../words/translate.tsx";

export function Why({ report, names }: { report: TranslateReport; names: EndNames }) {
  const { from, to } = report;
  return (
    <div class="why">
      <p>
        {whyWords.sentence({
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
      ? whyWords.same(names, from.direction, byFrom)
      : whyWords.transposed(names, from.direction, [byFrom, byTo]);
  }
  return (
    <>
      {whyWords.each(names, [from.direction, to.direction], [byFrom, byTo])}
      {sameAction ? whyWords.inverse : whyWords.asAsked(<Of action="R" />, <Of action="C" />)}
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
    ? whyWords.orderStays(to.order, to.constructorOrder)
    : whyWords.scalarMoves[to.order];
}
