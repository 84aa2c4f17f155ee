// What is said of an input by the whole core alone: of blocks that hold a rotation, and of what mends a text.
import type { ComponentChildren } from "preact";
import type { BesideQuantity, Fact, FoundInText, Remedy } from "../../engine.ts";
import type { Unit } from "../../model/page_state.ts";
import { shown, shownRoughAngle } from "../../number/format.ts";
import { rough } from "./notes.tsx";

/** What the core of the first load never tells. */
type WholeFact = Extract<
  Fact,
  {
    kind:
      | "far-from-unit"
      | "columns-from-text"
      | "found-in-text"
      | "second-description"
      | "descriptions-disagree"
      | "format-assumed"
      | "said-elsewhere";
  }
>;

const quantities: Record<BesideQuantity, string> = { position: "position", scale: "scale" };

const quotedLabel = (label: string | undefined) =>
  label === undefined ? null : (
    <>
      {" "}
      (<q>{label}</q>)
    </>
  );

const numbersOf = (numbers: readonly number[]) => (
  <code>{numbers.map((number) => shown(number, "all")).join(" ")}</code>
);

/** What stands around the rotation in a text, and where that puts the body. */
function foundWords({ format, label, beside }: FoundInText): ComponentChildren {
  return (
    <>
      {format === undefined ? <>Found in the text</> : <>Found in a text of {format}</>}
      {quotedLabel(label)}
      {beside.map(({ quantity, label: own, numbers, bodyInWorld }) => (
        <>
          ; {quantities[quantity]}
          {quotedLabel(own)} {numbersOf(numbers)}
          {bodyInWorld !== undefined && !areSame(numbers, bodyInWorld) && (
            <>, which puts the body at {numbersOf(bodyInWorld)} in the world</>
          )}
        </>
      ))}
      .
    </>
  );
}

/** Whether two lists of numbers are the same. */
const areSame = (one: readonly number[], other: readonly number[]) =>
  one.every((number, at) => number === other[at]);

/** The first thing that numbers of such a norm may be; absent where a double cannot hold it. */
export const aQuaternion = (norm: number | undefined) =>
  `A quaternion of norm ${norm === undefined ? "beyond a double" : rough(norm, 3)}`;

/** What there is to know, as one plain line. */
export function wholeNoteWords(fact: WholeFact, unit: Unit): ComponentChildren {
  switch (fact.kind) {
    case "far-from-unit":
      return (
        <>
          {aQuaternion(fact.norm)}? Or a point, an axis and an angle, a position with a yaw or a
          time?
        </>
      );
    case "found-in-text":
      return foundWords(fact);
    case "second-description":
      return (
        <>
          The text holds the rotation a second time{quotedLabel(fact.label)}: the two agree within{" "}
          <code>{shownRoughAngle(fact.differsByDeg, unit, 2)}</code>.
        </>
      );
    case "descriptions-disagree":
      return (
        <>
          The text holds another rotation{quotedLabel(fact.label)},{" "}
          <code>{shownRoughAngle(fact.differsByDeg, unit)}</code> away from the one that was read:{" "}
          <code>{fact.text}</code>
        </>
      );
    case "format-assumed":
      return (
        <>
          Nothing names these numbers: read as a row of <strong>{fact.format}</strong>, as which
          they pass.
        </>
      );
    case "said-elsewhere":
      return (
        <>
          The text also says <q>{fact.words}</q>: if that is said of these numbers, it is{" "}
          <strong>{fact.what}</strong>, which was not used.
        </>
      );
    case "columns-from-text":
      return (
        <>
          The text says that these are columns. As rows they are the inverse rotation,{" "}
          <code>{shownRoughAngle(fact.rowsDifferByDeg, unit)}</code> away.
        </>
      );
  }
}

/** What the buttons beside a problem are called. */
export const remedyWords: Record<Remedy, string> = {
  "match-brackets": "Fix the brackets",
  "decimal-points": "Write decimal points",
  "plain-characters": "Write plain characters",
  "remove-mark": "Remove the mark",
  "attach-sign": "Join the sign to its number",
  "separate-numbers": "Separate the numbers",
  "add-sign": "Add the sign",
  "add-zeros": "Write 0 for what is missing",
  "name-number": "Name the number",
  "same-unit": "Write the unit",
  "write-zero": "Write 0",
  "write-identity": "Write the identity",
  "restore-axis": "Flip the axis",
  "nearest-rotation": "Write the nearest rotation",
  "as-quaternion": "A quaternion",
  "as-axis-angle": "Axis and angle",
  "as-yaw": "Position and yaw",
  "as-euler-angles": "Euler angles",
  "this-rotation": "Read this one",
  "with-sequence": "Write the sequence",
  "other-order": "Read the other order",
  "rename-frame": "Write this name",
  "add-pose": "Add a row",
};
