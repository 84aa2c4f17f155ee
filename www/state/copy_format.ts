// The format that one click copies: the last chosen one, numbers at first.
import { signal } from "@preact/signals";
import { type Format, formats } from "../model/copy_formats.ts";

const storageKey = "quatlas.copy-format";

/** A browser may refuse to store, and what is stored may be of another version. */
function stored(): Format {
  try {
    const text = localStorage.getItem(storageKey);
    return formats.find(({ id }) => id === text)?.id ?? "numbers";
  } catch {
    return "numbers";
  }
}

const chosen = signal<Format>(stored());

export const chosenFormat = () => chosen.value;

export function chooseFormat(format: Format) {
  chosen.value = format;
  try {
    localStorage.setItem(storageKey, format);
  } catch {
    // It is still chosen for as long as the page is open.
  }
}
