// A number of the result that was edited, as a text of the whole attitude that the core reads; pure.
import type { AngleUnit, ComponentOrder, Direction, EulerSequence, Span } from "../engine.ts";
import { type ComponentName, namesOf } from "../model/component_order.ts";
import { sequenceName } from "../model/euler_sequence.ts";
import type { PageState } from "../model/page_state.ts";

/** What a group of numbers describes the attitude by. */
export type Description =
  | {
      kind: "components";
      /** The name of each number. */
      names: readonly ComponentName[];
      /** The order that is declared. */
      order: ComponentOrder;
      /** Whether the declared components are the conjugate of these. */
      isConjugate: boolean;
    }
  | { kind: "matrix"; direction: Direction }
  /** The angle, then the axis. */
  | { kind: "axis-angle"; unit: AngleUnit }
  | { kind: "rotation-vector" }
  | { kind: "euler-angles"; sequence: EulerSequence; unit: AngleUnit };

export interface EditedText {
  text: string;
  /** Where each number stands in the text. */
  places: readonly Span[];
}

/** Stands where a number is missing, so that the text is refused at its place. */
const missing = "?";

/**
 * The text that says the same as the typed parts. A part can be anything that the core reads as one
 * number; it cannot take the place of another one, because what is no plain number is bracketed.
 */
export function editedText(description: Description, parts: readonly string[]): EditedText {
  switch (description.kind) {
    case "components": {
      const { names, order, isConjugate } = description;
      const pieces = namesOf[order].flatMap((name, at): Piece[] => {
        const place = names.indexOf(name);
        const number = numberText(parts[place] ?? "");
        const text = isConjugate && name !== "w" ? opposite(number) : number;
        // With the names of a quaternion, so that any norm is only told.
        return [`${at === 0 ? "" : ", "}q${name}=`, { place, text }];
      });
      return written(pieces);
    }
    case "matrix": {
      const before = (at: number) => (at === 0 ? "[" : at % 3 === 0 ? "; " : ", ");
      const numbers = parts.map(numberText);
      return written([...numbers.flatMap((text, at) => [before(at), { place: at, text }]), "]"]);
    }
    case "axis-angle": {
      const [angle = "", ...axis] = parts;
      const [text = ""] = angleTexts([angle], description.unit);
      return written([{ place: 0, text }, " about ", ...list(axis.map(numberText), 1)]);
    }
    case "rotation-vector":
      return written([
        "rotvec ",
        ...list(
          radianTexts(parts.map((part) => angleOf(part, "radians"))).map(({ text }) => text),
          0,
        ),
        " rad",
      ]);
    case "euler-angles": {
      const angles = angleTexts(parts, description.unit);
      return written([
        sequenceName(description.sequence),
        ...angles.flatMap((text, at): Piece[] => [at === 0 ? " " : ", ", { place: at, text }]),
      ]);
    }
  }
}

/** What an edit changes: nine numbers also say which way they lead. */
export function editedState(description: Description, text: string): Partial<PageState> {
  if (description.kind !== "matrix") return { quaternion: text };
  return {
    quaternion: text,
    matrix: { function: "passive", direction: description.direction },
  };
}

type Piece = string | { place: number; text: string };

function written(pieces: readonly Piece[]): EditedText {
  const places: Span[] = [];
  let text = "";
  for (const piece of pieces) {
    if (typeof piece === "string") {
      text += piece;
    } else {
      places[piece.place] = { start: text.length, end: text.length + piece.text.length };
      text += piece.text;
    }
  }
  return { text, places };
}

/** `[0, 0, 1]`, whose numbers have the places from `first` on. */
function list(texts: readonly string[], first: number): Piece[] {
  const before = (at: number) => (at === 0 ? "[" : ", ");
  return [...texts.flatMap((text, at) => [before(at), { place: first + at, text }]), "]"];
}

const plainNumber = /^[-+−]?(?:\d+\.?\d*|\.\d+)(?:e[-+−]?\d+)?$/i;

function numberText(part: string): string {
  const text = part.trim();
  if (text === "") return missing;
  return plainNumber.test(text) ? text : `(${text})`;
}

function opposite(number: string): string {
  if (number === missing || Number(number) === 0) return number;
  if (!plainNumber.test(number)) return `-${number}`;
  const size = number.replace(/^[-+−]/, "");
  return /^[-−]/.test(number) ? size : `-${size}`;
}

/** An angle with the unit that it was typed with, or that its field has; a π means radians. */
interface Angle {
  text: string;
  unit: AngleUnit;
}

const endingUnit = /\s*(deg|°|rad)$/i;
const hasPi = /pi|tau|π|τ/i;

function angleOf(part: string, unit: AngleUnit): Angle {
  const trimmed = part.trim();
  const ending = endingUnit.exec(trimmed);
  const text = numberText(ending ? trimmed.slice(0, ending.index) : trimmed);
  if (ending) return { text, unit: ending[1]?.toLowerCase() === "rad" ? "radians" : "degrees" };
  return { text, unit: hasPi.test(text) ? "radians" : unit };
}

/** The angles of one text have one unit: degrees only where all of them are in degrees. */
function angleTexts(parts: readonly string[], unit: AngleUnit): string[] {
  const angles = parts.map((part) => angleOf(part, unit));
  if (angles.every((angle) => angle.unit === "degrees"))
    return angles.map(({ text }) => `${text}°`);
  return radianTexts(angles).map(({ text }) => `${text} rad`);
}

function radianTexts(angles: readonly Angle[]): Angle[] {
  return angles.map(({ text, unit }) => ({
    text: unit === "radians" || text === missing || Number(text) === 0 ? text : `(${text}*pi/180)`,
    unit: "radians",
  }));
}
