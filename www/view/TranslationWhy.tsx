// What is done to four numbers on the way, and why, with the frames.
import type { CosineMatrix, TranslatedEnd, TranslateReport } from "../engine.ts";
import { takesWords } from "./library_words.ts";
import type { EndNames } from "./Translate.tsx";
import { lettersOf } from "./words.ts";

/** `Reordered, not conjugated` and the like. */
export function changeWords({ change, axes }: TranslateReport): string {
  const words = {
    copied: "Neither reordered nor conjugated",
    reordered: "Reordered, not conjugated",
    conjugated: "Conjugated, not reordered",
    "reordered-and-conjugated": "Reordered and conjugated",
  }[change];
  return axes ? `${words}, and on other axes` : words;
}

export function Why({ report, names }: { report: TranslateReport; names: EndNames }) {
  const { from, to } = report;
  return (
    <div class="why">
      <p>
        {[from, to].some(({ assumed }) => assumed.includes("action")) && (
          <strong>As is assumed, for it is not established: </strong>
        )}
        <Frames from={from} to={to} names={names} />{" "}
        <strong>
          {isConjugated(report) ? "The vector part changes its sign" : "Nothing is conjugated"}
        </strong>
        , <OrderWords from={from} to={to} />.
        {report.axes && <> The new axes then change the numbers once more.</>}
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
  const both = `${names.from} and ${names.to}`;
  if (sameAction && sameDirection) {
    return (
      <>
        {both} both take {takesWords[from.direction]} by <Of action={from.action} />.
      </>
    );
  }
  const each = (
    <>
      {names.from} takes {takesWords[from.direction]} by <Of action={from.action} />, {names.to}{" "}
      takes {takesWords[to.direction]} by <Of action={to.action} />.
    </>
  );
  if (sameAction) {
    return <>{each} One undoes the other, so each is the inverse of the other.</>;
  }
  if (sameDirection) {
    return (
      <>
        {both} both take {takesWords[from.direction]}, one by <Of action={from.action} />, one by{" "}
        <Of action={to.action} />, which for the same numbers are transposes: to be one and the same
        matrix they need conjugate numbers.
      </>
    );
  }
  return (
    <>
      {each} For the same numbers <Of action="R" /> and <Of action="C" /> are transposes, which is
      just what the two directions ask for.
    </>
  );
}

/** In one piece where lines are broken. */
const unbroken = (words: string) => words.replaceAll(" ", "\u00a0");

export function Of({ action }: { action: CosineMatrix }) {
  return (
    <>
      <var>{action}</var>(<var>q</var>)
    </>
  );
}

function OrderWords({ from, to }: { from: TranslatedEnd; to: TranslatedEnd }) {
  if (from.order === to.order) {
    const { constructorOrder } = to;
    return (
      <>
        and the order of the array stays {unbroken(lettersOf[to.order])}
        {constructorOrder !== undefined && constructorOrder !== to.order && (
          <> (the constructor takes {unbroken(lettersOf[constructorOrder])})</>
        )}
      </>
    );
  }
  return to.order === "scalar-first" ? (
    <>and the scalar moves from the end to the front</>
  ) : (
    <>and the scalar moves from the front to the end</>
  );
}
