// What was done by a button or a key that changes the texts, for the one live region of the page.
import { signal } from "@preact/signals";
import type { PageState } from "./address.ts";

const said = signal<{ words: string; of: PageState } | undefined>(undefined);

/** Says what made the state as it is now. */
export function say(words: string, of: PageState) {
  said.value = { words, of };
}

/** What was said of this state; nothing once it is another one. */
export function saidOf(state: PageState): string {
  return said.value?.of === state ? said.value.words : "";
}
