// The buttons of undo and redo, and what is said when one of them, or its key, was used.
import { useRef } from "preact/hooks";
import type { Store } from "../state.ts";
import { undoWords } from "../words/edit.ts";

const isMac = /Mac|iPhone|iPad/.test(navigator.platform);
const keys = isMac
  ? { undo: "Meta+Z", redo: "Meta+Shift+Z" }
  : { undo: "Control+Z", redo: "Control+Shift+Z" };

export function UndoRedo({ store }: { store: Store }) {
  const ways = [
    {
      name: undoWords.undo,
      key: keys.undo,
      can: store.canUndo.value,
      move: store.undo,
      icon: "M6 3 L2.5 6.5 L6 10 M2.5 6.5 H10 a3.25 3.25 0 0 1 0 6.5 H6.5",
    },
    {
      name: undoWords.redo,
      key: keys.redo,
      can: store.canRedo.value,
      move: store.redo,
      icon: "M10 3 L13.5 6.5 L10 10 M13.5 6.5 H6 a3.25 3.25 0 0 0 0 6.5 H9.5",
    },
  ];
  return (
    <div class="undo">
      {ways.map(({ name, key, can, move, icon }) => (
        <button
          key={name}
          type="button"
          aria-label={name}
          aria-keyshortcuts={key}
          title={`${name} (${key.replace("Control", "Ctrl").replace("Meta", "⌘")})`}
          // It keeps the focus when its last step is undone.
          aria-disabled={!can}
          onClick={move}
        >
          <svg viewBox="0 0 16 16" width="16" height="16" aria-hidden="true">
            <path d={icon} />
          </svg>
        </button>
      ))}
      <Said store={store} />
    </div>
  );
}

/** Says once what was undone; the result is said by the page. */
function Said({ store }: { store: Store }) {
  const said = useRef({ text: "", of: store.lastUndone.value });
  const last = store.lastUndone.value;
  if (last !== said.current.of) {
    const text = last === undefined ? "" : undoWords[last.way](last.parts);
    // The same words again are said again only where the text differs.
    const again = text !== "" && text === said.current.text ? "\u00a0" : "";
    said.current = { text: text + again, of: last };
  }
  return (
    <span class="visually-hidden" aria-live="polite" data-said="undo">
      {said.current.text}
    </span>
  );
}
