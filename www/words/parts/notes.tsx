// What is said of an input, and what the buttons that fix it are called.
import type { ComponentChildren } from "preact";
import type {
  ComponentOrder,
  Direction,
  Handedness,
  Note,
  OrderSource,
  OutOfRangeNumber,
} from "../../engine.ts";
import type { Digits, Unit } from "../../model/page_state.ts";
import { shown, shownRoughAngle } from "../../number/format.ts";
import { lettersOf, symbolOf } from "../conventions.ts";

const otherLetters: Record<ComponentOrder, string> = {
  "scalar-first": lettersOf["scalar-last"],
  "scalar-last": lettersOf["scalar-first"],
};

const sources: Record<OrderSource, string> = {
  declared: "declaration",
  named: "names",
  grouped: "brackets",
  constructor: "constructor",
  label: "words",
  format: "format",
};

const outOfRange: Record<OutOfRangeNumber, string> = {
  norm: "With this norm the numbers for the new axes are beyond the range of a double: those of norm 1 are shown.",
  inverse: "The inverse is beyond the range of a double and is left out.",
  image: "The rotated vector is beyond the range of a double and is left out.",
  product: "The product is beyond the range of a double: that of the unit quaternions is shown.",
  position: "The position is beyond the range of a double and is left out.",
};

const directionWords: Record<Direction, string> = {
  "body-to-world": "body to world",
  "world-to-body": "world to body",
};

const productNames: Record<Handedness, string> = { right: "Hamilton", left: "JPL" };

/** A number of two or three digits, for a sentence. */
export const rough = (number: number, precision = 2) =>
  shown(Number(number.toPrecision(precision)), "all");

const roughDegrees = (degrees: number) => shownRoughAngle(degrees, "degrees", 2);

/** The words of what the whole core alone tells; they come with it. */
export const wholeWords: { there?: typeof import("./whole_notes.tsx") } = {};

/** What there is to know, as one plain line. */
export function noteWords({ field, fact }: Note, digits: Digits, unit: Unit): ComponentChildren {
  const symbol = <var>{symbolOf[field]}</var>;
  switch (fact.kind) {
    case "normalised":
      return fact.norm === undefined || fact.deviation === undefined ? (
        <>The norm is beyond the range of a double: the matrices use the unit quaternion.</>
      ) : (
        <>
          The norm is <code>{shown(fact.norm, digits === "4" ? "6" : digits)}</code>, off from 1 by{" "}
          <code>{rough(fact.deviation)}</code>: the matrices use {symbol}/|{symbol}|.
        </>
      );
    case "rotation-assumed":
      return (
        <>
          <q>{fact.label}</q> does not say what these numbers are: read as a rotation, as which they
          pass. They may be something else.
        </>
      );
    case "direction-from-text":
      return (
        <>
          The text says{" "}
          <strong>
            {fact.handedness && `${productNames[fact.handedness]}, `}
            {directionWords[fact.direction]}
          </strong>
          , which is not what is declared; the text wins.
        </>
      );
    case "order-from-text":
      return (
        <>
          The order in the text, by its {sources[fact.source]}, is {lettersOf[fact.order]}, not the
          declared one; the text wins.
        </>
      );
    case "order-assumed":
      return (
        <>
          Bare numbers do not tell their order: read as{" "}
          <code class="letters">{lettersOf[fact.order]}</code>. As{" "}
          <code class="letters">{otherLetters[fact.order]}</code> they would be a rotation{" "}
          <code>{shownRoughAngle(fact.otherOrderDiffersByDeg, unit)}</code> away.
        </>
      );
    case "order-invisible":
      return (
        <>
          This input cannot show its order: as <code class="letters">w x y z</code> and as{" "}
          <code class="letters">x y z w</code> it is the same rotation. Test with another one.
        </>
      );
    case "unknown-constructor":
      return (
        <>
          The order of <code>{fact.name}</code> is not known here: read as{" "}
          <code class="letters">{lettersOf[fact.order]}</code>, as declared.
        </>
      );
    case "angle-unit-assumed":
      return fact.unit === "degrees" ? (
        <>
          The angles have no unit: read as <strong>degrees</strong>, since one of them is more than
          a full turn in radians.
        </>
      ) : (
        <>
          The angles have no unit: read as <strong>radians</strong>.
        </>
      );
    case "rows-assumed":
      return (
        <>
          Nothing marks the rows of the nine numbers: read row by row. Column by column they are the
          inverse rotation, <code>{shownRoughAngle(fact.columnsDifferByDeg, unit)}</code> away.
        </>
      );
    case "axes-as-columns":
      return (
        <>
          Vectors with the names of axes are the rotated axes: read as the columns of the matrix. As
          rows they are the inverse rotation,{" "}
          <code>{shownRoughAngle(fact.rowsDifferByDeg, unit)}</code> away.
        </>
      );
    case "nearest-rotation":
      return (
        <>
          The matrix is not quite a rotation (<var>M</var>
          <sup>T</sup>
          <var>M</var> is off from <var>I</var> by up to{" "}
          <code>{rough(fact.orthogonalityError)}</code>): the nearest rotation is used,{" "}
          <code>{rough(fact.correction)}</code> away.
        </>
      );
    case "negative-scalar":
      return (
        <>
          The scalar is negative: −{symbol} is the same rotation, and the angle below is that of −
          {symbol}, the shorter way.
        </>
      );
    case "no-turn":
      return (
        <>
          This is the identity: no rotation. Apart from the order of the numbers, it cannot tell
          conventions apart.
        </>
      );
    case "nearly-no-turn":
      return (
        <>
          Nearly no rotation, <code>{roughDegrees(fact.angleDeg)}</code> (
          <code>{rough(fact.angleRad)}</code> rad): with six decimals the axis of the quaternion{" "}
          {fact.axisUncertainByDeg === undefined ? (
            <>is lost.</>
          ) : (
            <>
              is off by up to <code>{shownRoughAngle(fact.axisUncertainByDeg, unit, 2)}</code>.
            </>
          )}
        </>
      );
    case "half-turn":
      return (
        <>
          Half a turn: the axis and its opposite are equally right, and the matrix is its own
          transpose. Apart from the order of the numbers, it cannot tell conventions apart.
        </>
      );
    case "nearly-half-turn":
      return (
        <>
          Nearly half a turn, short of it by <code>{roughDegrees(fact.shortByDeg)}</code> (
          <code>{rough(fact.shortByRad)}</code> rad): rounding may flip the axis, and the sign of{" "}
          {symbol}.
        </>
      );
    case "out-of-range":
      return outOfRange[fact.what];
    default:
      return wholeWords.there?.wholeNoteWords(fact, unit);
  }
}

/** What the buttons that fix an input are called. */
export const fixWords = {
  normalise: (symbol: string) => `Write ${symbol}/|${symbol}|`,
  negate: (symbol: string) => `Write −${symbol}`,
  readAs: (letters: string) => `Read as ${letters}`,
  declare: (letters: string) => `Declare ${letters}`,
  degrees: "These are degrees",
  radians: "These are radians",
  columns: "Read column by column",
  rows: "Read row by row",
  nearestRotation: "Write the nearest rotation",
};

/** What is heard of a note that stops the reader. */
export const spokenStop = (symbol: string, words: string) => `Check ${symbol}: ${words}`;

/** What was done, for those who do not see it. */
export const doneWords = (label: string) => `Done: ${label}.`;

export const fixKey = "Alt+Enter";

export const problemWords = {
  expected: "Expected:",
  try: "Try:",
  old: "Showing the last valid result.",
  opening: "Showing the opening example.",
  /** Until it is known what a text is. */
  reading: "Reading …",
  /** Where only the kind of a problem is known. */
  unsaid: (code: string) => `this is not read here (${code})`,
  missing:
    "Other forms, and what is wrong in words, are in a part of the page that could not be loaded. Check the connection and",
};

/** The scalar's sign does not matter, which is plain to few. */
export const otherSign = {
  heading: "The other sign",
  words: "The same rotation, not its inverse.",
};

/** What is left of the angles at gimbal lock; `names` are those of the three angles. */
export function gimbalLockWords({
  names,
  sign,
  survivor,
  lost,
  distance,
}: {
  names: readonly string[];
  sign: string;
  survivor: string;
  lost: string | undefined;
  /** From the lock; absent exactly at it. */
  distance: string | undefined;
}): ComponentChildren {
  return (
    <>
      <strong>Gimbal lock</strong>
      {distance !== undefined && (
        <>
          {" "}
          (<code>{distance}</code> from it)
        </>
      )}
      : the first and third axes coincide, only {names[0]} {sign} {names[2]} ={" "}
      <code>{survivor}</code> is determined, and {lost} is set to 0.
    </>
  );
}

/** What a small distance from gimbal lock does to the angles. */
export function nearLockWords(distanceDeg: number, unit: Unit): ComponentChildren {
  const times = 180 / (Math.PI * distanceDeg);
  return (
    <>
      <strong>Near gimbal lock</strong> (<code>{shownRoughAngle(distanceDeg, unit, 2)}</code> from
      it): errors of the attitude are up to <code>{rough(times)}</code> times as large in the first
      and third angles.
    </>
  );
}
