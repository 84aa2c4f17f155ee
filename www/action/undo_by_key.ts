// Undo and redo by key, wherever the focus is: the texts are the state's, so the browser's own undo of
// a text field would take back what the page never knew.
import type { Store } from "../state/store.ts";
import { redo, undo } from "./undo.ts";

export function undoByKey(store: Store) {
  addEventListener("keydown", (event) => {
    const move = moveOf(event);
    if (move === undefined || event.isComposing) return;
    const field = textField(document.activeElement);
    if (field?.dataset["undo"] === "own") return;
    event.preventDefault();
    const before = field?.value;
    move(store);
    // The page writes what was undone in a microtask that waits already.
    queueMicrotask(() => {
      if (field === undefined || before === undefined || field.value === before) return;
      const at = endOfChange(before, field.value);
      field.setSelectionRange(at, at);
    });
  });
}

function moveOf(event: KeyboardEvent): ((store: Store) => void) | undefined {
  if (!(event.ctrlKey || event.metaKey) || event.altKey) return undefined;
  const key = event.key.toLowerCase();
  if (key === "z") return event.shiftKey ? redo : undo;
  return key === "y" && !event.shiftKey ? redo : undefined;
}

function textField(element: Element | null) {
  const isText =
    element instanceof HTMLTextAreaElement ||
    (element instanceof HTMLInputElement && ["text", "search"].includes(element.type));
  return isText ? element : undefined;
}

/** Where what is different in a text ends. */
export function endOfChange(before: string, after: string): number {
  let same = 0;
  const most = Math.min(before.length, after.length);
  while (same < most && before.at(-1 - same) === after.at(-1 - same)) same += 1;
  return after.length - same;
}
