// What the keys do.
import type { Preset, View } from "../../model/page_state.ts";
import type { ShortcutName } from "../../model/shortcut_name.ts";
import type { Tab } from "../../model/tabs.ts";

const goTo = (view: string) => `Go to ${view}`;
const declare = (preset: string) => `Declare the text as ${preset}`;

export const viewShortcutWords: Record<View, string> = {
  read: goTo("Read"),
  compose: goTo("Compose"),
  motion: goTo("Motion"),
  frames: goTo("Frames"),
  translate: goTo("Translate"),
  identify: goTo("Identify"),
  libraries: goTo("All libraries"),
};

const goToTab = (tab: string) => `Go to ${tab}, to the part used last`;

/** A tab of one view is gone to by the keys of that view. */
const tabShortcutWords: Record<`tab ${Tab}`, string> = {
  "tab read": goToTab("Read"),
  "tab compose": goToTab("Compose"),
  "tab motion": goToTab("Motion"),
  "tab frames": goToTab("Frames"),
  "tab libraries": goToTab("Libraries"),
};

export const presetShortcutWords: Record<Preset, string> = {
  hamilton: declare("Hamilton"),
  jpl: declare("JPL"),
};

export const shortcutWords: Record<ShortcutName, string> = {
  ...viewShortcutWords,
  ...tabShortcutWords,
  ...presetShortcutWords,
  field: "Go to the first text field",
  copy: "Copy the quaternion",
  digits: "More or fewer decimals",
  unit: "Angles in degrees or radians",
  theme: "Light, dark or as the system",
  gallery: "Open the examples",
  help: "Open this list",
  undo: "Undo",
  redo: "Redo",
  mend: "Fix the text of a field as the button says that shows these keys",
};

/** What the keys do in the numbers of the result, in one that is edited, and in the list of libraries. */
export const innerKeys = [
  {
    heading: "On the numbers of the result",
    rows: [
      { keys: ["Arrow\u00a0keys"], does: "From number to number" },
      {
        keys: ["Home", "End"],
        does: "To the ends of the row; with Ctrl, to the first and the last",
      },
      { keys: ["Enter", "F2"], does: "Edit the number; what is typed replaces it" },
    ],
  },
  {
    heading: "In a number that is edited",
    rows: [
      {
        keys: ["↑", "↓"],
        does: "Step by 0.01 or 1°; Shift: 10 times that, Alt: a tenth",
      },
      { keys: ["Enter"], does: "Keep the edit; the arrow keys lead on" },
      { keys: ["Escape"], does: "Take the edit back" },
      { keys: ["Tab"], does: "Keep the edit and leave these numbers" },
    ],
  },
  {
    heading: "In the list of libraries",
    rows: [
      { keys: ["↑", "↓"], does: "From library to library" },
      { keys: ["Home", "End"], does: "To the first and the last" },
      { keys: ["Enter"], does: "Open or close the record" },
    ],
  },
] as const;

export const orWord = "or";
export const thenWord = "then";

export const whereTheyAct =
  "A key alone acts while no text field has the focus. Undo, redo and fixing act in text fields too. What is pasted in Read, Compose or Translate while no field has the focus goes into the first one. On the picture the arrow keys look round, and with Shift they turn the body.";
export const remembered = "The theme and this choice are remembered in this browser only.";
