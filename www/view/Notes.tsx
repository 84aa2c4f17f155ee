// What a careful reader should know about the input: one plain line each.
import type { ComponentChildren } from "preact";
import type { Digits, Unit } from "../address.ts";
import type { ComponentOrder, Note, OrderSource } from "../engine.ts";
import { shown, shownRoughAngle } from "../format.ts";
import { lettersOf, symbolOf } from "./words.ts";

export function Notes({
  notes,
  digits,
  unit,
}: {
  notes: readonly Note[];
  digits: Digits;
  unit: Unit;
}) {
  if (notes.length === 0) return null;
  return (
    <ul class="notes">
      {notes.map((note) => (
        <li key={`${note.field} ${note.fact.kind}`}>
          {(note.field === "p" || note.field === "q") && (
            <>
              <var>{note.field}</var>:{" "}
            </>
          )}
          {words(note, digits, unit)}
        </li>
      ))}
    </ul>
  );
}

const otherOrder: Record<ComponentOrder, ComponentOrder> = {
  "scalar-first": "scalar-last",
  "scalar-last": "scalar-first",
};

const sources: Record<OrderSource, string> = {
  declared: "declaration",
  named: "names",
  grouped: "brackets",
  constructor: "constructor",
};

function words({ field, fact }: Note, digits: Digits, unit: Unit): ComponentChildren {
  const symbol = <var>{symbolOf[field]}</var>;
  switch (fact.kind) {
    case "normalised":
      return fact.norm === undefined || fact.deviation === undefined ? (
        <>The norm is beyond the range of a double; the matrices use the quaternion of norm 1.</>
      ) : (
        <>
          The norm is <code>{shown(fact.norm, digits === "4" ? "6" : digits)}</code>, off from 1 by{" "}
          <code>{shown(Number(fact.deviation.toPrecision(2)), "all")}</code>: the matrices use{" "}
          {symbol}/|{symbol}|.
        </>
      );
    case "order-from-text":
      return (
        <>
          The text tells its order by its {sources[fact.source]} ({lettersOf[fact.order]}
          ), which is not the declared one; the text wins.
        </>
      );
    case "order-assumed":
      return (
        <>
          Bare numbers do not tell their order: read as <code>{lettersOf[fact.order]}</code>. As{" "}
          <code>{lettersOf[otherOrder[fact.order]]}</code> they would be a rotation{" "}
          <code>{shownRoughAngle(fact.otherOrderDiffersByDeg, unit)}</code> away.
        </>
      );
    case "order-invisible":
      return (
        <>
          This input cannot show its order: as <code>w x y z</code> and as <code>x y z w</code> it
          is the same rotation. Test with another one.
        </>
      );
    case "unknown-constructor":
      return (
        <>
          The order of <code>{fact.name}</code> is not known here: read as{" "}
          <code>{lettersOf[fact.order]}</code>, as declared.
        </>
      );
    case "angle-unit-assumed":
      return fact.unit === "degrees" ? (
        <>
          The angles have no unit: read as <strong>degrees</strong>, since one of them is more than
          a full turn in radians. Write <code>deg</code> or <code>rad</code> to be sure.
        </>
      ) : (
        <>
          The angles have no unit: read as <strong>radians</strong>. Write <code>deg</code> or{" "}
          <code>rad</code> to be sure.
        </>
      );
    case "rows-assumed":
      return (
        <>
          Nothing marks the rows of the nine numbers: read row by row. Column by column, as some
          libraries print them, they are the opposite turn,{" "}
          <code>{shownRoughAngle(fact.columnsDifferByDeg, unit)}</code> away.
        </>
      );
    case "nearest-rotation":
      return (
        <>
          The matrix is not quite a rotation (<var>M</var>
          <sup>T</sup>
          <var>M</var> is off from <var>I</var> by up to{" "}
          <code>{shown(Number(fact.orthogonalityError.toPrecision(2)), "all")}</code>): the nearest
          rotation is used, <code>{shown(Number(fact.correction.toPrecision(2)), "all")}</code>{" "}
          away.
        </>
      );
    case "negative-scalar":
      return (
        <>
          The scalar is negative: −{symbol} is the same rotation and names the shorter turn, which
          is the one given below.
        </>
      );
    case "no-turn":
      return (
        <>
          This is no turn at all. Apart from the order of the numbers, it tells no convention from
          another.
        </>
      );
    case "half-turn":
      return (
        <>
          Half a turn: the axis and its opposite are equally right, and the matrix is its own
          transpose. Apart from the order of the numbers, it tells no convention from another.
        </>
      );
    case "out-of-range":
      return outOfRange[fact.what];
  }
}

const outOfRange = {
  norm: "The norm is beyond the range of a double.",
  inverse: "The inverse is beyond the range of a double and is left out.",
  image: "The turned vector is beyond the range of a double and is left out.",
  product:
    "The product of the numbers as typed is beyond the range of a double; the product of the quaternions of norm 1 is shown.",
} as const;
