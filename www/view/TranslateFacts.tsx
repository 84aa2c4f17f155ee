// What else a translation changes: the product, the mistakes, the axes.
import { type Digits, toFragment, type Unit } from "../address.ts";
import type {
  AxesReport,
  Direction,
  Engine,
  MappedAxes,
  MistakeKind,
  TranslatedEnd,
  TranslateReport,
} from "../engine.ts";
import { fromDegrees, shownAngle } from "../format.ts";
import type { Store } from "../state.ts";
import { libraryWith, notEstablished } from "./library_words.ts";
import type { EndNames } from "./Translate.tsx";
import { Matrix } from "./Value.tsx";

/** How `a * b` of the first end is written at the second. */
export function ProductCard({
  report,
  names,
  store,
}: {
  report: TranslateReport;
  names: EndNames;
  store: Store;
}) {
  const { engine } = store;
  const { from, to, product } = report;
  const isKnown = product === "same" || product === "reversed";
  return (
    <section class="fact" aria-labelledby="product-name">
      <h2 id="product-name">A product</h2>
      {isKnown && (
        <p class="fact-value product-line">
          <code>{productOf(from, engine)}</code>
          <span class="product-becomes">becomes</span>
          <code>
            {product === "reversed" ? swapped(productOf(to, engine)) : productOf(to, engine)}
          </code>
        </p>
      )}
      <p>
        {isKnown && (
          <ProductWords from={from} to={to} names={names} isReversed={product === "reversed"} />
        )}
        {product === "neither" && (
          <>
            The axes of the world and of the body change differently. So the product of two
            translated attitudes is <strong>neither of the two products</strong>: multiply first,
            then translate the result.
          </>
        )}
        {product === "not-established" && (
          <>
            The product of one of the two is {notEstablished}; a message has none of its own, only
            the library that reads it. With what a library prints,{" "}
            <a href={`#${toFragment({ ...store.state.value, view: "identify" })}`}>Identify</a>{" "}
            finds it out.
          </>
        )}
      </p>
    </section>
  );
}

/** Which operand acts first at either end, and whether both lead the same way. */
function ProductWords({
  from,
  to,
  names,
  isReversed,
}: {
  from: TranslatedEnd;
  to: TranslatedEnd;
  names: EndNames;
  isReversed: boolean;
}) {
  const sameFirst = from.firstToAct === to.firstToAct;
  const sameWay = from.direction === to.direction;
  return (
    <>
      {sameFirst
        ? `In both, the ${from.firstToAct} operand acts first on a vector`
        : `In ${names.from} the ${from.firstToAct} operand acts first, in ${names.to} the ${to.firstToAct} one`}
      {sameWay
        ? `, and both lead ${wayWords[from.direction]}`
        : `; one leads ${wayWords[from.direction]}, the other back`}
      . So, with <var>a</var> and <var>b</var> translated,{" "}
      <strong>
        {isReversed ? "the operands change places" : "the operands keep their places"}
      </strong>
      .
    </>
  );
}

const wayWords: Record<Direction, string> = {
  "body-to-world": "from body to world",
  "world-to-body": "from world to body",
};

function productOf(end: TranslatedEnd, engine: Engine): string {
  return libraryWith(engine, end.library)?.code?.product ?? "a * b";
}

/** The call with its operands in each other's place. */
const swapped = (call: string) =>
  call.replace(/\b[ab](?=\b|0\b|vec\b)/g, (operand) => (operand === "a" ? "b" : "a"));

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
  const mistakes = mistakesOf(report);
  return (
    <section class="fact mistakes" aria-labelledby="mistakes-name">
      <h2 id="mistakes-name">What goes wrong with these numbers</h2>
      <ul>
        {mistakes.map(({ words, angleDeg }) => (
          <li key={words}>
            <span class="mistake-words">{words}</span>
            {angleDeg === 0 ? (
              <span class="mistake-none">
                no difference: these numbers do not show the mistake, others will
              </span>
            ) : (
              <>
                <span class="mistake-angle">
                  <code>{shownAngle(fromDegrees(angleDeg), digits, unit)}</code> off
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

const mistakeWords: Record<MistakeKind, string> = {
  copied: "copied as they are",
  "not-reordered": "not reordered",
  "not-conjugated": "not conjugated",
  "conjugated-needlessly": "conjugated, though it must not be",
  "constructor-order": "passed to the constructor as the array stands",
  "axes-kept": "axes not changed",
};

function mistakesOf({ mistakes, change }: TranslateReport) {
  const both = change === "reordered-and-conjugated";
  const done = { "not-reordered": "conjugated, but ", "not-conjugated": "reordered, but " };
  return mistakes.map(({ kind, angleDeg }) => {
    const before =
      both && (kind === "not-reordered" || kind === "not-conjugated") ? done[kind] : "";
    return { words: before + mistakeWords[kind], angleDeg };
  });
}

/** The change of axes, with its matrices. */
export function AxesCard({ axes, digits }: { axes: AxesReport; digits: Digits }) {
  const isMirrored = axes.world.hand === "changed";
  return (
    <section class="card column custom" aria-labelledby="axes-name">
      <header>
        <h2 id="axes-name">The change of axes</h2>
        <p class="effect">
          The new matrix is <var>A</var>
          <sub>world</sub> <var>R</var> <var>A</var>
          <sub>body</sub>
          <sup>T</sup>, with <var>R</var> from body to world.
        </p>
      </header>
      <div class="matrices">
        <Mapped of="world" mapped={axes.world} digits={digits} />
        <Mapped of="body" mapped={axes.body} digits={digits} />
      </div>
      <p class="hand-words">
        {axes.world.text !== axes.body.text ? (
          <>
            World and body change differently, so the turn that leads from the one to the other is
            another one than before
            {isMirrored && ", counted by the other hand of both"}. Determinants of different sign
            would make a reflection, which has no quaternion.
          </>
        ) : isMirrored ? (
          <>
            <strong>Both change the hand of the axes</strong>: right-handed ones become left-handed,
            or the other way round. The turn in space stays the same, but it is counted by the other
            hand: what was counter-clockwise about an axis, seen against it, is now clockwise. So
            the rotation vector becomes −<var>A</var> times the old one, not <var>A</var> times. One
            side alone would be a reflection, which has no quaternion.
          </>
        ) : (
          <>
            Both keep the hand of the axes (determinant +1), so a turn that was counter-clockwise
            about an axis is so still.
          </>
        )}
      </p>
    </section>
  );
}

function Mapped({
  of,
  mapped,
  digits,
}: {
  of: "world" | "body";
  mapped: MappedAxes;
  digits: Digits;
}) {
  return (
    <Matrix
      name={`new axes of the ${of}`}
      symbol={
        <>
          <var>A</var>
          <sub>{of}</sub>
        </>
      }
      caption={`new x y z = ${mapped.text.replaceAll("-", "−")}, determinant ${
        mapped.determinant > 0 ? "+1" : "−1"
      }`}
      rows={mapped.rows}
      digits={digits}
    />
  );
}
