// What can be done with a key.
import type { Preset, View } from "./page_state.ts";
import type { Tab } from "./tabs.ts";

export type ShortcutName =
  | View
  | `tab ${Tab}`
  | Preset
  | ("field" | "copy" | "digits" | "unit" | "theme" | "gallery" | "help")
  | ("undo" | "redo" | "mend");
