// How the page is shown: decimals, angles, theme.
import type { Digits, Unit } from "../model/page_state.ts";
import type { ShortcutsChoice, Theme } from "../model/settings.ts";

export const decimalsLabel = "Decimals";
export const digitsWords: Record<Digits, string> = { "4": "4", "6": "6", all: "all" };

export const anglesLabel = "Angles";
export const unitWords: Record<Unit, string> = { degrees: "deg", radians: "rad" };
export const unitNames: Record<Unit, string> = { degrees: "degrees", radians: "radians" };

export const themeLabel = "Theme";
export const themeWords: Record<Theme, string> = {
  system: "as the system",
  light: "light",
  dark: "dark",
};

export const shortcutsLabel = "Single-key shortcuts";
export const shortcutsWords: Record<ShortcutsChoice, string> = { on: "on", off: "off" };

/** What a setting now is; for the tool, and aloud after a key. */
export const isNow = (setting: string, choice: string) => `${setting}: ${choice}`;
