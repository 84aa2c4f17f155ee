// What was just done, in words: one place for all that a button, a key or a copy has to say. The page has
// one live region, which reads it out, and shows for a while what has no other sign on the page.
import { signal } from "@preact/signals";

/** What is read out. */
export const announcement = signal("");
/** What is also shown. */
export const notice = signal("");

const shownForMs = 2400;
let hiding: ReturnType<typeof setTimeout> | undefined;

/** Reads out what was done. */
export function announce(words: string) {
  // The same words again are read out again only where the text differs.
  announcement.value = words === announcement.peek() ? `${words}\u00a0` : words;
}

/** Reads out and shows what was done; for what nothing else on the page shows. */
export function announceVisibly(words: string) {
  announce(words);
  clearTimeout(hiding);
  notice.value = words;
  hiding = setTimeout(() => {
    notice.value = "";
  }, shownForMs);
}

/** Something else is done now. */
export function endAnnouncement() {
  announcement.value = "";
}
