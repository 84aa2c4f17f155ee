// What was just done, in words: one place for all that a button, a key or a copy has to say. The one live
// region of the page reads it out, and shows for a while what has no other sign on the page.
import { batch, signal } from "@preact/signals";

export const announcement = signal("");
/** Whether it is not only read out. */
export const isAnnouncementShown = signal(false);

const shownForMs = 2400;
let hiding: ReturnType<typeof setTimeout> | undefined;

/** Reads out what was done. */
export function announce(words: string) {
  clearTimeout(hiding);
  batch(() => {
    // The same words again are read out again only where the text differs.
    announcement.value = words === announcement.peek() ? `${words}\u00a0` : words;
    isAnnouncementShown.value = false;
  });
}

/** Reads out and shows what was done; for what nothing else on the page shows. */
export function announceVisibly(words: string) {
  batch(() => {
    announce(words);
    isAnnouncementShown.value = true;
  });
  hiding = setTimeout(() => {
    isAnnouncementShown.value = false;
    endAnnouncement();
  }, shownForMs);
}

/** Something else is done now; what is shown stays for its time. */
export function endAnnouncement() {
  if (!isAnnouncementShown.peek()) announcement.value = "";
}
