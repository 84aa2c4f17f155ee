// What mends an input: for each note and each problem, another text or another declaration.
import type {
  ComponentOrder,
  Components,
  Field,
  Note,
  ReadQuaternion,
  ReadReport,
  Suggestion,
} from "../engine.ts";
import { markOf, namesOf, otherOrder } from "../model/component_order.ts";
import { declaredConvention, differing, operatorOf } from "../model/conventions.ts";
import type { PageState, View } from "../model/page_state.ts";
import { exact } from "../number/format.ts";
import { announce } from "../state/announcement.ts";
import type { Store } from "../state/store.ts";
import { namedConventions } from "../values.ts";
import { lettersOf, symbolOf } from "../words/conventions.ts";
import { doneWords, fixWords, wholeWords } from "../words/parts/notes.tsx";
import { read } from "./read_on.ts";

export interface Fix {
  /** What it does, as its button says. */
  label: string;
  /** What it writes, where the button shows it. */
  text?: string | undefined;
  /** A new text ends what was to be said; a declaration may leave it to be said the other way round. */
  changes: "text" | "declaration";
  /** Computed where it is used, not on every keystroke; nothing where it cannot be. */
  change: () => Partial<PageState> | undefined;
}

/** The field whose text a problem or a note is about, as the state names it. */
export type TextName =
  | "quaternion"
  | "p"
  | "q"
  | "vector"
  | "translated"
  | "rate"
  | "rateEnd"
  | "duration"
  | "increment"
  | "worldAxes"
  | "bodyAxes";

const textNames: Partial<Record<Field, TextName>> = {
  quaternion: "quaternion",
  p: "p",
  q: "q",
  vector: "vector",
  "world-axes": "worldAxes",
  "body-axes": "bodyAxes",
  rate: "rate",
  "rate-end": "rateEnd",
  increment: "increment",
};

function textNameOf(field: Field, view: View): TextName | undefined {
  return view === "translate" && field === "quaternion" ? "translated" : textNames[field];
}

/** What may be written in place of a text with a problem. */
export function fixOfProblem(store: Store, field: Field): Fix | undefined {
  const name = textNameOf(field, store.state.value.view);
  const suggestion = store.problemOf(field)?.suggestion;
  return name && suggestion && writing(name, suggestion);
}

/** The texts of which a problem asks to choose one; no key chooses. */
export function choicesOfProblem(store: Store, field: Field): Fix[] {
  const name = textNameOf(field, store.state.value.view);
  const choices = store.problemOf(field)?.choices ?? [];
  if (name === undefined) return [];
  return choices.map((choice) => {
    const fix = writing(name, choice);
    // A sequence says it all, without the same numbers once more.
    return choice.remedy === "with-sequence" ? { ...fix, text: undefined } : fix;
  });
}

const writing = (
  name: TextName,
  { remedy, text, label = wholeWords.there?.remedyWords[remedy] ?? remedy }: Suggestion,
): Fix => ({
  label,
  text,
  changes: "text",
  change: () => ({ [name]: text }),
});

/** What a note can be answered with, in the order of the buttons. */
export function fixesOfNote(store: Store, note: Note): Fix[] {
  const name = textNameOf(note.field, store.state.value.view);
  if (name === undefined) return [];
  const { fact, suggestions } = note;
  const offered = suggestions.map((suggestion) => {
    const fix = writing(name, suggestion);
    if (fact.kind !== "far-from-unit" || suggestion.remedy !== "as-quaternion") return fix;
    // That says it all, without the same numbers once more.
    return {
      ...fix,
      label: wholeWords.there?.aQuaternion(fact.norm) ?? fix.label,
      text: undefined,
    };
  });
  return [...ownFixes(store, note, name), ...offered];
}

/** Those that follow from the kind of a note. */
function ownFixes(store: Store, { field, fact }: Note, name: TextName): Fix[] {
  const { view } = store.state.value;
  const symbol = symbolOf[field];
  const writes = (label: string, text: (report: ReadReport) => string): Fix => ({
    label,
    changes: "text",
    change: () => {
      const report = readAlone(store, field, name);
      return report && { [name]: text(report) };
    },
  });
  const writesText = (label: string, text: string | undefined): Fix[] =>
    text === undefined ? [] : [{ label, changes: "text", change: () => ({ [name]: text }) }];
  const normalises = writes(fixWords.normalise(symbol), ({ declared, quaternion }) =>
    named(declared.unit, quaternion),
  );
  switch (fact.kind) {
    case "normalised":
      return [normalises];
    case "out-of-range":
      return fact.what === "inverse" || fact.what === "norm" ? [normalises] : [];
    case "negative-scalar":
      return [negates(store, field, name)];
    case "order-from-text":
      return declaresOrder(store, fact.order, fixWords.declare);
    case "order-assumed":
    case "unknown-constructor":
      return declaresOrder(store, otherOrder[fact.order], fixWords.readAs);
    case "angle-unit-assumed": {
      const degrees = writesText(fixWords.degrees, fact.inDegrees);
      const radians = writesText(fixWords.radians, fact.inRadians);
      // Degrees are what is meant nearly always: where they were taken, and where they were not.
      return [...degrees, ...radians];
    }
    case "rows-assumed":
      return [writes(fixWords.columns, ({ quaternion: { form } }) => transposedRows(form))];
    case "axes-as-columns":
    case "columns-from-text":
      return [writes(fixWords.rows, ({ quaternion: { form } }) => transposedRows(form))];
    case "nearest-rotation":
      return view === "translate" ? [] : [writes(fixWords.nearestRotation, nearestRows)];
    default:
      return [];
  }
}

/** Writes the quaternion of the other sign, which is the same rotation. */
export function negates(store: Store, field: Field, name: TextName): Fix {
  return {
    label: fixWords.negate(symbolOf[field]),
    changes: "text",
    change: () => {
      const quaternion = readAlone(store, field, name)?.quaternion;
      if (quaternion === undefined) return undefined;
      const { w, x, y, z } = quaternion.components;
      return { [name]: named({ w: 0 - w, x: 0 - x, y: 0 - y, z: 0 - z }, quaternion) };
    },
  };
}

/** Those that stop the reader before the others. */
export const stopsFirst = (notes: readonly Note[]) => [
  ...notes.filter(({ stops }) => stops),
  ...notes.filter(({ stops }) => !stops),
];

/** The notes of the view that is shown, where they are about its texts as they are now. */
function currentNotes(store: Store): readonly Note[] {
  const { view } = store.state.value;
  if (view !== "read" && view !== "compose" && view !== "translate") return [];
  const result = store[view].value;
  return result?.freshness === "current" ? stopsFirst(result.report.notes) : [];
}

/** What stops the reader of the texts as they are now. */
export const stopping = (store: Store) => currentNotes(store).filter(({ stops }) => stops);

/**
 * The fix that the key applies in a field, which its button says: one that settles something before
 * another declaration, also where that stands first. Nobody changes a convention by a habit of the hand.
 */
export function keyFix(store: Store, field: Field): Fix | undefined {
  const ofProblem = fixOfProblem(store, field);
  if (ofProblem !== undefined) return ofProblem;
  const fixes = currentNotes(store)
    .filter((note) => note.field === field)
    .flatMap((note) => fixesOfNote(store, note));
  return fixes.find(({ changes }) => changes === "text") ?? fixes[0];
}

/** What the key does in a field; later, where it is not known yet what its text is. */
export function applyFirst(store: Store, field: Field): boolean {
  if (store.isReading.peek()) {
    const asked = store.state.peek();
    read(store).then(() => store.state.peek() === asked && applyFirst(store, field));
    return false;
  }
  const fix = keyFix(store, field);
  if (fix !== undefined) apply(store, fix);
  return fix !== undefined;
}

export function apply(store: Store, fix: Fix) {
  const change = fix.change();
  if (change === undefined) return;
  // A step of its own, however fast the hand that typed before.
  store.step();
  store.set(change);
  store.step();
  announce(doneWords(fix.label));
}

/** What one text alone is, in the convention in which it was read. */
function readAlone(store: Store, field: Field, name: TextName): ReadReport | undefined {
  const state = store.state.peek();
  const read = quaternionOf(store, field);
  if (read === undefined) return undefined;
  const { form, convention } = read;
  const outcome = store.engine.analyze({
    view: "read",
    quaternion: state[name],
    vector: "1 0 0",
    convention,
    matrix: form.kind === "matrix" ? form.convention : state.matrix,
    euler: state.euler,
  });
  return outcome.status === "read" ? outcome : undefined;
}

function quaternionOf(store: Store, field: Field): ReadQuaternion | undefined {
  switch (store.state.peek().view) {
    case "read":
      return store.read.peek()?.report.quaternion;
    case "compose": {
      const report = store.compose.peek()?.report;
      return field === "p" ? report?.p : report?.q;
    }
    case "translate":
      return store.translate.peek()?.report.quaternion;
    default:
      return undefined;
  }
}

/** With names, so that no order is needed; in the order that was used. */
function named(
  components: Pick<Components, "w" | "x" | "y" | "z">,
  { convention }: ReadQuaternion,
): string {
  const mark = markOf(components);
  const parts = namesOf[convention.order].map(
    (name) => `${mark}${name}=${exact(components[name])}`,
  );
  return parts.join(" ");
}

function declaresOrder(
  store: Store,
  order: ComponentOrder,
  label: (letters: string) => string,
): Fix[] {
  const state = store.state.peek();
  // There the order is that of the library.
  if (state.view === "translate") return [];
  return [
    {
      label: label(lettersOf[order]),
      changes: "declaration",
      change: () => {
        const changed = { ...declaredConvention(store.state.peek()), order };
        return { axes: differing(changed, namedConventions[state.preset]) };
      },
    },
  ];
}

const rowsText = (rows: readonly (readonly number[])[]) =>
  rows.map((row) => row.map(exact).join(" ")).join("\n");

function transposedRows(form: ReadQuaternion["form"]): string {
  if (form.kind !== "matrix") return "";
  return rowsText(form.rows.map((_, column) => form.rows.map((row) => row[column] ?? 0)));
}

function nearestRows({ quaternion: { form }, hamilton }: ReadReport): string {
  if (form.kind !== "matrix") return "";
  const isBodyToWorld = operatorOf(form.convention) === "body-to-world";
  return rowsText(isBodyToWorld ? hamilton.matrix : hamilton.inverseMatrix);
}
