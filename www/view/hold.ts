// What stands above the result keeps its height while numbers of the result are edited, so that the
// field under the cursor stays where it is. The text field is high enough again once it has the focus.

const heldParts = ".field-hero .field-text, .ask-status";

/** Keeps the heights as they are. */
export function hold() {
  for (const part of document.querySelectorAll<HTMLElement>(heldParts)) {
    if (part.classList.contains("held")) continue;
    part.style.setProperty("--held-height", `${part.offsetHeight}px`);
    part.classList.add("held");
  }
}

function release() {
  for (const part of document.querySelectorAll(".held")) part.classList.remove("held");
}

/** Lets go where the text itself is edited, another one is opened, or the window changes. */
export function releaseOnLeaving() {
  document.addEventListener("focusin", (event) => {
    if (event.target instanceof Element && event.target.closest(".ask textarea")) release();
  });
  addEventListener("hashchange", release);
  addEventListener("resize", release);
}
