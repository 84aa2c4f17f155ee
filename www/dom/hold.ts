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

/** So long after the last key a text may be complete. Less than what a browser takes for its own doing. */
const restMs = 350;

/**
 * What is said of a text keeps its height while somebody types, and takes what it needs when the hand
 * rests or leaves: with every key a problem may come or go, and the result would jump.
 */
export function holdWhileTyping() {
  let rest: ReturnType<typeof setTimeout> | undefined;
  const letGo = () => {
    clearTimeout(rest);
    document.querySelector(".ask-status.typing")?.classList.remove("typing");
  };
  // Before the page is written again.
  const onInput = ({ target }: Event) => {
    if (!(target instanceof Element && target.matches(".ask textarea"))) return;
    const status = document.querySelector<HTMLElement>(".ask-status");
    if (status === null) return;
    if (!status.classList.contains("typing")) {
      status.style.setProperty("--typing-height", `${status.getBoundingClientRect().height}px`);
      status.classList.add("typing");
    }
    clearTimeout(rest);
    rest = setTimeout(letGo, restMs);
  };
  addEventListener("input", onInput, { capture: true });
  addEventListener("focusout", letGo);
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
