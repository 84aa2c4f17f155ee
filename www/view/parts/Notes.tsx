// What a careful reader should know about the input: one plain line each, with what mends it.
import { type ComponentChildren, isValidElement } from "preact";
import { apply, type Fix, fixesOfNote, keyFix, stopping, stopsFirst } from "../../action/fixes.ts";
import type { Fact, Field, Note } from "../../engine.ts";
import type { Store } from "../../state/store.ts";
import { symbolOf } from "../../words/conventions.ts";
import { fixKey, noteWords, spokenStop } from "../../words/parts/notes.tsx";
import "./notes.css";

/** Facts about the axis and the angle, which stand beside them in the Read view. */
const ofTheTurn: readonly Fact["kind"][] = [
  "no-turn",
  "nearly-no-turn",
  "half-turn",
  "nearly-half-turn",
];

export function Notes({ notes, store }: { notes: readonly Note[]; store: Store }) {
  const { digits, unit, view } = store.state.value;
  const here = notes.filter(({ fact }) => view !== "read" || !ofTheTurn.includes(fact.kind));
  if (here.length === 0) return null;
  return (
    <ul class="notes">
      {stopsFirst(here).map((note) => (
        <li
          key={`${note.field} ${note.fact.kind}`}
          id={note.stops ? stopId(note) : undefined}
          class={note.stops ? "note-stops" : undefined}
        >
          {noteWords(note, digits, unit)}
          {fixesOfNote(store, note).map((fix) => (
            <FixButton
              key={`${fix.label} ${fix.text}`}
              store={store}
              field={note.field}
              fix={fix}
            />
          ))}
        </li>
      ))}
    </ul>
  );
}

const stopId = ({ field, fact }: Note) => `stop-${field}-${fact.kind}`;

/** The ids of the notes that stop the reader of a text. */
export const stopIds = (store: Store, field: Field): string[] =>
  stopping(store)
    .filter((note) => note.field === field)
    .map(stopId);

/** What a screen reader hears of them before the result. */
export function spokenStops(store: Store): string[] {
  const { digits, unit } = store.state.value;
  return stopping(store).map((note) =>
    spokenStop(symbolOf[note.field], plainText(noteWords(note, digits, unit))),
  );
}

/** The text of words with their marks. */
function plainText(words: ComponentChildren): string {
  if (Array.isArray(words)) return words.map(plainText).join("");
  if (isValidElement(words)) return plainText(words.props.children);
  return typeof words === "string" || typeof words === "number" ? `${words}` : "";
}

/** The note about the turn, where there is one. */
export function NoteOfTurn({ notes, store }: { notes: readonly Note[]; store: Store }) {
  const note = notes.find(({ fact }) => ofTheTurn.includes(fact.kind));
  if (note === undefined) return null;
  const { digits, unit } = store.state.value;
  return <p class="note-beside">{noteWords(note, digits, unit)}</p>;
}

/** A button that mends a text; the first of a field has a key as well. */
export function FixButton({ store, field, fix }: { store: Store; field: Field; fix: Fix }) {
  const first = keyFix(store, field);
  const hasKey = first?.label === fix.label && first.text === fix.text;
  return (
    <>
      {" "}
      <button
        type="button"
        class="fix"
        aria-keyshortcuts={hasKey ? fixKey : undefined}
        onClick={(event) => {
          const button = event.currentTarget;
          apply(store, fix);
          // A finger would be given a keyboard that it did not ask for.
          if ((event as unknown as PointerEvent).pointerType !== "touch") {
            requestAnimationFrame(() => focusFieldAfter(button, field));
          }
        }}
      >
        <span class="fix-label">{fix.label}</span>
        {fix.text !== undefined && <code class="fix-text">{fix.text}</code>}
        {hasKey && (
          <span class="fix-key" aria-hidden="true">
            {fixKey}
          </span>
        )}
      </button>
    </>
  );
}

/** Where the button is gone with what it mended, the focus goes to the text. */
function focusFieldAfter(button: HTMLButtonElement, field: Field) {
  if (button.isConnected) return;
  document.querySelector<HTMLElement>(`[data-field="${field}"] textarea`)?.focus();
}
