// What stands above the result keeps its height while numbers of the result are edited, so that the
// field under the cursor stays where it is. The text field is high enough again once it has the focus.

const heldParts = ".field-hero .field-text, .ask-status";

/** Keeps the heights as they are; what needs more in the meantime keeps that. */
export function hold() {
  document.documentElement.classList.add("holding");
  for (const part of document.querySelectorAll<HTMLElement>(heldParts)) {
    const height = `${part.getBoundingClientRect().height}px`;
    // Usually nothing changes, and nothing has to be laid out again.
    if (part.style.getPropertyValue("--held-height") !== height) {
      part.style.setProperty("--held-height", height);
    }
    part.classList.add("held");
  }
}

/**
 * Does an edit in such a field. Where the texts above need more lines than before all the same, the
 * page is scrolled by as much, which not every browser does by itself.
 */
export function inPlace(field: HTMLElement, edit: () => void) {
  hold();
  const { top } = field.getBoundingClientRect();
  edit();
  // The page is written in a microtask that waits already.
  queueMicrotask(() => {
    const by = field.getBoundingClientRect().top - top;
    if (by !== 0) scrollBy({ top: by, behavior: "instant" });
  });
}

function release() {
  document.documentElement.classList.remove("holding");
  for (const part of document.querySelectorAll(".held")) part.classList.remove("held");
}

/** Lets go where the text itself is edited, another one is opened, or the width changes. */
export function releaseOnLeaving() {
  document.addEventListener("focusin", (event) => {
    if (
      event.target instanceof Element &&
      event.target.closest(".ask")?.contains(event.target) &&
      event.target.matches("textarea")
    )
      release();
  });
  addEventListener("hashchange", release);
  // The keyboard of a phone changes the height alone.
  let width = innerWidth;
  addEventListener("resize", () => {
    if (innerWidth !== width) release();
    width = innerWidth;
  });
}
