// What is done to four numbers on the way, and why, with the frames.
import type { CosineMatrix, Engine, TranslatedEnd, TranslateReport } from "../../engine.ts";
import type { Store } from "../../state/store.ts";
import { meansWords } from "../../words/library_behaviour.ts";
import type { EndNames } from "../../words/translate/translate.ts";
import * as words from "../../words/translate/why.tsx";
import { libraryWith } from "../parts/library.ts";

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

/** Where an end has no quaternion: what either end says, and nothing of conjugates. */
export function WhyNumbers({
  report,
  names,
  store,
}: {
  report: TranslateReport;
  names: EndNames;
  store: Store;
}) {
  return (
    <div class="why">
      {(["from", "to"] as const).map((side) => (
        <p key={side}>
          {words.by(
            names[side],
            <By end={report[side]} engine={store.engine} />,
            report[side].direction,
          )}
        </p>
      ))}
    </div>
  );
}

/** What takes coordinates at an end: the product of its turns, its vector, its matrix, its quaternion. */
function By({ end, engine }: { end: TranslatedEnd; engine: Engine }) {
  if (end.numbers === undefined) return <Of action={end.action} />;
  const numbers = libraryWith(engine, end.library)?.numbers;
  if (numbers?.means === undefined) return <>{words.byIts[end.numbers.kind]}</>;
  return <code>{meansWords(numbers)}</code>;
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
