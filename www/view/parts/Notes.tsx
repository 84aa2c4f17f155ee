// What a careful reader should know about the input: one plain line each, with what mends it.
import type { ComponentChildren } from "preact";
import { apply, type Fix, fixesOfNote, keyFix } from "../../action/fixes.ts";
import type { Fact, Field, Note } from "../../engine.ts";
import type { Store } from "../../state/store.ts";
import { fixKey, noteWords } from "../../words/parts/notes.tsx";
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
      {here.map((note) => (
        <li key={`${note.field} ${note.fact.kind}`}>
          {noteWords(note, digits, unit)}
          {fixesOfNote(store, note).map((fix) => (
            <FixButton key={fix.label} store={store} field={note.field} fix={fix} />
          ))}
        </li>
      ))}
    </ul>
  );
}

/** The note about the turn, where there is one. */
export function NoteOfTurn({ notes, store }: { notes: readonly Note[]; store: Store }) {
  const note = notes.find(({ fact }) => ofTheTurn.includes(fact.kind));
  if (note === undefined) return null;
  const { digits, unit } = store.state.value;
  return <p class="note-beside">{noteWords(note, digits, unit)}</p>;
}

/** A button that mends a text; the first of a field has a key as well. */
export function FixButton({
  store,
  field,
  fix,
  children,
}: {
  store: Store;
  field: Field;
  fix: Fix;
  /** What stands on it after its label. */
  children?: ComponentChildren;
}) {
  const hasKey = keyFix(store, field)?.label === fix.label;
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
        {children}
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
