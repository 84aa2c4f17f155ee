// What is remembered from visit to visit, in this browser only.
import { signal } from "@preact/signals";
import { type Digits, digitChoices, type Unit, unitChoices } from "../model/page_state.ts";
import type { ShortcutsChoice, Theme } from "../model/settings.ts";
import { shortcutChoices, themes } from "../model/settings.ts";
import type { Store } from "./store.ts";

type Appearance = Exclude<Theme, "system">;

const choices = {
  theme: themes,
  digits: digitChoices,
  unit: unitChoices,
  shortcuts: shortcutChoices,
} as const;
type Setting = keyof typeof choices;
type Chosen<Name extends Setting> = (typeof choices)[Name][number];

// first.js reads the same key.
const keyOf = (setting: Setting) => `quatlas-${setting}`;

/** What was chosen; nothing where nothing was, or where a former or foreign value stands. */
function remembered<Name extends Setting>(setting: Name): Chosen<Name> | undefined {
  try {
    const stored = localStorage.getItem(keyOf(setting));
    const known: readonly Chosen<Name>[] = choices[setting];
    return known.find((choice) => choice === stored);
  } catch {
    // A private window, or storage that is refused.
    return undefined;
  }
}

/** Keeps a choice for the next visit; where that is refused, it holds for this one. */
function remember<Name extends Setting>(setting: Name, choice: Chosen<Name>) {
  try {
    localStorage.setItem(keyOf(setting), choice);
  } catch {}
}

/** How numbers are shown on a page that was opened without a link to a case. */
export function rememberedNumbers(): { digits?: Digits; unit?: Unit } {
  const [digits, unit] = [remembered("digits"), remembered("unit")];
  return { ...(digits && { digits }), ...(unit && { unit }) };
}

export const theme = signal<Theme>(remembered("theme") ?? "system");
export const shortcuts = signal<ShortcutsChoice>(remembered("shortcuts") ?? "on");

export function chooseTheme(chosen: Theme) {
  theme.value = chosen;
  remember("theme", chosen);
  showTheme();
}

/** The theme that is chosen in another tab is that of this one too. */
export function followTheme() {
  addEventListener("storage", ({ key }) => {
    if (key !== null && key !== keyOf("theme")) return;
    theme.value = remembered("theme") ?? "system";
    showTheme();
  });
}

export function chooseDigits(store: Store, digits: Digits) {
  store.set({ digits });
  remember("digits", digits);
}

export function chooseUnit(store: Store, unit: Unit) {
  store.set({ unit });
  remember("unit", unit);
}

export function chooseShortcuts(chosen: ShortcutsChoice) {
  shortcuts.value = chosen;
  remember("shortcuts", chosen);
}

/** What the theme is after this one: the other appearance, the system's by hand, the system's. */
export function nextTheme(): Theme {
  const ofSystem: Appearance = matchMedia("(prefers-color-scheme: dark)").matches
    ? "dark"
    : "light";
  if (theme.value === ofSystem) return "system";
  return theme.value === "system" ? opposite[ofSystem] : ofSystem;
}

const opposite: Record<Appearance, Appearance> = { light: "dark", dark: "light" };

/** Gives the theme to the style sheet, and its colour to the frame that the browser draws. */
export function showTheme() {
  const { dataset } = document.documentElement;
  if (theme.value === "system") delete dataset["theme"];
  else dataset["theme"] = theme.value;
  for (const meta of document.querySelectorAll<HTMLMetaElement>("meta[data-theme]")) {
    const own = meta.dataset["theme"];
    if (theme.value === "system") meta.media = `(prefers-color-scheme: ${own})`;
    else meta.media = own === theme.value ? "all" : "not all";
  }
}
