// What somebody typed into the page, chose and pressed before the program was there.

type Control = HTMLInputElement | HTMLTextAreaElement | HTMLSelectElement | HTMLButtonElement;

/** What was done with a control, or where the cursor stands in it. */
export interface Typed {
  /** The place among all controls; a page that is rendered again has the same. */
  at: number;
  value: string;
  isTouched: boolean;
  hasFocus: boolean;
  selection: [start: number, end: number];
}

const controlsOf = (root: HTMLElement) => [
  ...root.querySelectorAll<Control>("input, textarea, select, button"),
];

const isRadio = (control: Control): control is HTMLInputElement => control.type === "radio";
const isButton = (control: Control) => control instanceof HTMLButtonElement;
const isSelect = (control: Control) => control instanceof HTMLSelectElement;

function isTouched(control: Control): boolean {
  // Written by first.js.
  if (isButton(control)) return "pressed" in control.dataset;
  if (isRadio(control)) return control.checked && !control.defaultChecked;
  if (isSelect(control)) return control.selectedOptions[0]?.defaultSelected === false;
  return control.value !== control.defaultValue;
}

/** What was done with the controls of the page since it is there, and where the focus is. */
export function typedInto(root: HTMLElement): Typed[] {
  return controlsOf(root)
    .map((control, at) => ({
      at,
      value: control.value,
      isTouched: isTouched(control),
      hasFocus: control === document.activeElement,
      selection: selectionOf(control),
    }))
    .filter(({ isTouched, hasFocus }) => isTouched || hasFocus);
}

function selectionOf(control: Control): Typed["selection"] {
  if (isSelect(control) || isButton(control)) return [0, 0];
  return [control.selectionStart ?? 0, control.selectionEnd ?? 0];
}

/** Does all of it as if it were done now. */
export function typeAgain(typed: Typed[], root: HTMLElement) {
  const controls = controlsOf(root);
  for (const { at, value, isTouched, hasFocus, selection } of typed) {
    const control = controls[at];
    if (control === undefined) continue;
    if (hasFocus) control.focus();
    if (isTouched) use(control, value);
    if (hasFocus && "setSelectionRange" in control && !isRadio(control)) {
      control.setSelectionRange(...selection);
    }
  }
}

function use(control: Control, value: string) {
  if (isButton(control)) {
    delete control.dataset["pressed"];
    control.click();
    return;
  }
  if (isRadio(control)) {
    // One that is chosen already is not chosen by a click.
    control.checked = false;
    control.click();
    return;
  }
  control.value = value;
  const type = isSelect(control) ? "change" : "input";
  control.dispatchEvent(new Event(type, { bubbles: true }));
}
