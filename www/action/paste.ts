// What is pasted while no text field has the focus goes into the first one, in place of its text.
import type { Store } from "../state/store.ts";
import { isTyping } from "./shortcuts.ts";

export function startPasting(store: Store) {
  addEventListener("paste", (event) => {
    if (event.defaultPrevented || isTyping(event.target)) return;
    const text = event.clipboardData?.getData("text/plain").trim() ?? "";
    const field = document.querySelector<HTMLTextAreaElement>("main .field-hero textarea");
    if (text === "" || field === null) return;
    event.preventDefault();
    store.step();
    field.focus();
    field.setRangeText(text, 0, field.value.length, "end");
    field.dispatchEvent(new InputEvent("input", { bubbles: true }));
  });
}
