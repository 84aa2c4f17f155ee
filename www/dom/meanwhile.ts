// What somebody did with the page before the program was there: typed, chose, pressed.

/** What first.js noted: a control, and what it held then where it holds something. */
interface Deed {
  control: Element;
  value?: string;
}

declare global {
  var doneFirst: readonly Deed[] | undefined;
}

type Control = HTMLInputElement | HTMLTextAreaElement | HTMLSelectElement | HTMLElement;

/** The deeds, and where the focus and the cursor are. Places count all controls of the page. */
export interface Meanwhile {
  deeds: { at: number; value: string | undefined }[];
  focusAt: number;
  cursor: [start: number, end: number] | undefined;
}

const controlsOf = (root: HTMLElement) => [
  ...root.querySelectorAll<Control>("input, textarea, select, button, a"),
];

/** Resolves once no text is being composed, as with the keyboard of another script: it is left alone so long. */
export async function composed() {
  const isComposing = document.documentElement.dataset["composing"] !== undefined;
  if (!isComposing) return;
  await new Promise((done) => addEventListener("compositionend", done, { once: true }));
  // The field takes the text after the event.
  await new Promise((done) => setTimeout(done));
}

/** What was done with the page since it is there. */
export function doneMeanwhile(root: HTMLElement): Meanwhile {
  const controls = controlsOf(root);
  const focused = document.activeElement as Control | null;
  const { doneFirst = [] } = globalThis;
  return {
    deeds: doneFirst
      .map(({ control, value }) => ({ at: controls.indexOf(control as Control), value }))
      .filter(({ at }) => at >= 0),
    focusAt: focused === null ? -1 : controls.indexOf(focused),
    cursor: isText(focused) ? [focused.selectionStart ?? 0, focused.selectionEnd ?? 0] : undefined,
  };
}

/**
 * Does all of it again, in its order, in a page that has the same controls. A press waits until what was typed
 * before is `answered`.
 */
export async function doAgain(
  { deeds, focusAt, cursor }: Meanwhile,
  root: HTMLElement,
  answered: () => Promise<void>,
) {
  const controls = controlsOf(root);
  const focused = controls[focusAt];
  focused?.focus();
  const restoreCursor = () => {
    if (cursor && isText(focused)) focused.setSelectionRange(...cursor);
  };
  restoreCursor();
  for (const { at, value } of deeds) {
    const control = controls[at];
    if (control === undefined) continue;
    if (value === undefined) await answered();
    use(control, value);
    if (control === focused) restoreCursor();
    // The page is written again.
    await new Promise((done) => setTimeout(done));
  }
}

function use(control: Control, value: string | undefined) {
  if (value === undefined) control.click();
  else if (control instanceof HTMLInputElement && control.type === "radio") {
    // One that is chosen already is not chosen by a click.
    control.checked = false;
    control.click();
  } else if ("value" in control) {
    control.value = value;
    const type = control instanceof HTMLSelectElement ? "change" : "input";
    control.dispatchEvent(new Event(type, { bubbles: true }));
  }
}

function isText(control: Element | null | undefined): control is HTMLInputElement {
  return (
    control instanceof HTMLTextAreaElement ||
    (control instanceof HTMLInputElement && control.type === "text")
  );
}
