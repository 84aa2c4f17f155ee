// What can be done with a key.
import type { Preset, View } from "./page_state.ts";

export type ShortcutName =
  | View
  | Preset
  | ("field" | "copy" | "digits" | "unit" | "theme" | "gallery" | "help")
  | ("undo" | "redo" | "mend");
