// Numbers of the result that are edited together: a quaternion, a matrix, the angles of a sequence.
import { signal } from "@preact/signals";
import type { Convention, Direction, Problem, Span } from "../../engine.ts";
import { namesOf } from "../../model/component_order.ts";
import { declaredConvention } from "../../model/conventions.ts";
import { type Description, editedState, editedText } from "../../number/edited_text.ts";
import { exact } from "../../number/format.ts";
import type { Store } from "../../state/store.ts";
import type { Rows } from "./roving.ts";

/** What a group of fields edits. */
export interface Edited {
  store: Store;
  /** Names the group: one of its own on the page. */
  id: string;
  describe: () => Description;
}

/** The numbers of a group as they stand in its fields, and what is done to them. */
export interface NumberGroup extends Edited {
  /** What was typed, as long as it is what the attitude was read from. */
  typed: readonly string[] | undefined;
  numbers: readonly number[];
  isWrong: (at: number) => boolean;
}

export function numberGroup(edited: Edited, numbers: readonly number[]): NumberGroup {
  const { store, id, describe } = edited;
  const draft = store.draft.value;
  const text = store.state.value.quaternion;
  const typed = draft?.group === id ? draft.parts.get(text) : undefined;
  const problem = typed && store.problemOf("quaternion");
  const isWrong = (at: number) => {
    if (typed === undefined || problem === undefined) return false;
    return touches(problem, editedText(describe(), typed).places[at]);
  };
  return { ...edited, typed, numbers, isWrong };
}

function touches({ span }: Problem, place: Span | undefined): boolean {
  return place !== undefined && span.start < place.end && place.start < span.end;
}

/** How the numbers stand: a matrix has rows of three, all others are one row. */
export function rowsOf({ describe, numbers: { length: count } }: NumberGroup): Rows {
  return { count, columns: describe().kind === "matrix" ? 3 : count };
}

/** The number of each group that the Tab key reaches: the last one that had the focus. */
const stops = signal<Readonly<Record<string, number>>>({});

export function stopOf({ id }: NumberGroup): number {
  return stops.value[id] ?? 0;
}

export function stopAt({ id }: NumberGroup, at: number) {
  stops.value = { ...stops.peek(), [id]: at };
}

/** What stands in a field while it is edited: every digit. */
export function partOf({ typed, numbers }: NumberGroup, at: number): string {
  return typed?.[at] ?? exact(numbers[at] ?? 0);
}

/** The numbers to be read in the fields: those that were typed, where they are numbers. */
export function shownNumbers({ typed, numbers }: NumberGroup): number[] {
  return numbers.map((number, at) => plainNumber(typed?.[at]) ?? number);
}

/** The number that a text is by itself. */
export function plainNumber(text: string | undefined): number | undefined {
  if (text === undefined || text.trim() === "") return undefined;
  const number = Number(text.trim().replace("−", "-"));
  return Number.isFinite(number) ? number + 0 : undefined;
}

/** Writes what was typed into one field, as a text of all of them. */
export function write(group: NumberGroup, at: number, typed: string) {
  const { store, id, describe, numbers } = group;
  const parts = numbers.map((_, place) => (place === at ? typed : partOf(group, place)));
  const description = describe();
  const { text } = editedText(description, parts);
  const draft = store.draft.peek();
  // The parts of earlier texts are kept for undo, as long as the group is edited.
  const earlier = draft?.group === id ? draft.parts : [];
  store.draft.value = { group: id, parts: new Map([...earlier, [text, parts]]) };
  store.set(editedState(description, text), { as: `editing ${id} ${at}` });
}

/** The group is left: what was typed stays only where it could not be read. */
export function leave({ store, id }: NumberGroup) {
  store.step();
  if (store.draft.peek()?.group !== id) return;
  if (store.problemOf("quaternion") === undefined) store.draft.value = undefined;
}

/** The four components of a column; of the presets, or of the convention that is declared. */
export function editedComponents(
  store: Store,
  id: string,
  { order }: Pick<Convention, "order">,
  of: "preset" | "declared",
): Edited {
  return {
    store,
    id,
    describe: () => {
      const { engine, state } = store;
      const declared = declaredConvention(state.peek());
      return {
        kind: "components",
        names: namesOf[order],
        order: declared.order,
        // The numbers of the presets are the canonical ones.
        isConjugate: of === "preset" && !engine.describe(declared).rules.isCanonical,
      };
    },
  };
}

export function editedMatrix(store: Store, id: string, direction: Direction): Edited {
  return { store, id, describe: () => ({ kind: "matrix", direction }) };
}

/** The number that a part says, which may have a unit; nothing where it says none. */
export function numberOf({ engine }: Store, part: string): number | undefined {
  const plain = plainNumber(part);
  if (plain !== undefined) return plain;
  // In brackets, as it stands in the text of the whole attitude.
  const number = engine.readNumber(`(${part.replace(/\s*(?:deg|°|rad)\s*$/i, "")})`);
  // Adding 0 makes no −0.
  return number === undefined ? undefined : number + 0;
}
