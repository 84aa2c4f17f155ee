// The buttons of undo and redo.
import { redo, undo } from "../../action/undo.ts";
import { isMac } from "../../dom/platform.ts";
import type { Store } from "../../state/store.ts";
import { undoWords } from "../../words/undo.ts";
import "./undo_redo.css";

const keysOf = {
  mac: { undo: "Meta+Z", redo: "Meta+Shift+Z" },
  other: { undo: "Control+Z", redo: "Control+Shift+Z" },
};

export function UndoRedo({ store }: { store: Store }) {
  const keys = keysOf[isMac.value ? "mac" : "other"];
  const ways = [
    {
      name: undoWords.undo,
      key: keys.undo,
      can: store.canUndo.value,
      move: () => undo(store),
      icon: "M6 3 L2.5 6.5 L6 10 M2.5 6.5 H10 a3.25 3.25 0 0 1 0 6.5 H6.5",
    },
    {
      name: undoWords.redo,
      key: keys.redo,
      can: store.canRedo.value,
      move: () => redo(store),
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
    </div>
  );
}
