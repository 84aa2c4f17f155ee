// One step back or forward in the view, and what is said of it.
import { announce } from "../state/announcement.ts";
import type { Store } from "../state/store.ts";
import { undoWords } from "../words/undo.ts";

export function undo(store: Store) {
  const parts = store.undo();
  if (parts) announce(undoWords.undone(parts));
}

export function redo(store: Store) {
  const parts = store.redo();
  if (parts) announce(undoWords.redone(parts));
}
