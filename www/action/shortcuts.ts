// The keys that do something by themselves. Help lists this table, so it is always true.
import { digitChoices, type Preset, unitChoices, type View } from "../model/page_state.ts";
import type { ShortcutName } from "../model/shortcut_name.ts";
import { partsOf, type Tab, tabNames } from "../model/tabs.ts";
import { announce } from "../state/announcement.ts";
import { showOverlay } from "../state/overlay.ts";
import { chooseDigits, chooseTheme, chooseUnit, nextTheme, shortcuts } from "../state/settings.ts";
import type { Store } from "../state/store.ts";
import { tabWords, viewNames } from "../words/frame/page.tsx";
import {
  anglesLabel,
  decimalsLabel,
  digitsWords,
  isNow,
  themeLabel,
  themeWords,
  unitNames,
} from "../words/settings.ts";

interface Shortcut {
  name: ShortcutName;
  /** Any of these; two keys one after the other with a space between them. */
  keys: readonly string[];
  /** What it returns is announced. */
  act: (store: Store) => string | undefined;
}

/** To a tab by its place, and to a view by its first letter. */
function goTo(tab: Tab, at: number): Shortcut[] {
  const place = String(at + 1);
  const [first, ...others] = partsOf(tab);
  if (first === undefined) return [];
  if (others.length === 0) return [goToView(first, place)];
  const toTab: Shortcut = {
    name: `tab ${tab}`,
    keys: [place],
    act: () => {
      press(`.views a[data-tab="${tab}"]`);
      return tabWords[tab];
    },
  };
  return [toTab, ...partsOf(tab).map((view) => goToView(view))];
}

const goToView = (view: View, ...otherKeys: string[]): Shortcut => ({
  name: view,
  keys: [...otherKeys, `g ${view.charAt(0)}`],
  act: (store) => {
    follow(store.linkTo({ view }));
    return viewNames[view];
  },
});

/** As a link does it, so that going back returns; not every view has one that is shown. */
function follow(address: string) {
  const link = document.createElement("a");
  link.href = address;
  document.body.append(link);
  link.click();
  link.remove();
}

const declare = (preset: Preset, key: string): Shortcut => ({
  name: preset,
  keys: [key],
  act: () => press(`main input[name="convention"][value="${preset}"]`),
});

function press(selector: string) {
  document.querySelector<HTMLElement>(selector)?.click();
  return undefined;
}

function next<Choice>(choices: readonly Choice[], chosen: Choice): Choice {
  return choices[(choices.indexOf(chosen) + 1) % choices.length] ?? chosen;
}

/** The quaternion that a view is about: as declared, of the product, as translated. */
const copyButtons =
  ".column:has(.badge) .copy-line button, .translation-end + .translation-end .strip button";

export const table: readonly Shortcut[] = [
  ...tabNames.flatMap(goTo),
  {
    name: "field",
    keys: ["/"],
    act: () => {
      document
        .querySelector<HTMLTextAreaElement | HTMLInputElement>(
          'main textarea, main input[type="search"]',
        )
        ?.select();
      return undefined;
    },
  },
  declare("hamilton", "h"),
  declare("jpl", "j"),
  { name: "copy", keys: ["c"], act: () => press(copyButtons) },
  {
    name: "digits",
    keys: ["d"],
    act: (store) => {
      const digits = next(digitChoices, store.state.peek().digits);
      chooseDigits(store, digits);
      return isNow(decimalsLabel, digitsWords[digits]);
    },
  },
  {
    name: "unit",
    keys: ["u"],
    act: (store) => {
      const unit = next(unitChoices, store.state.peek().unit);
      chooseUnit(store, unit);
      return isNow(anglesLabel, unitNames[unit]);
    },
  },
  {
    name: "theme",
    keys: ["t"],
    act: () => {
      const theme = nextTheme();
      chooseTheme(theme);
      return isNow(themeLabel, themeWords[theme]);
    },
  },
  {
    name: "gallery",
    keys: ["e"],
    act: () => showOverlay("gallery"),
  },
  { name: "help", keys: ["?"], act: () => showOverlay("help") },
];

/** Where letters are typed or choose something. */
const typing =
  'textarea, select, input:not([type="radio"], [type="checkbox"]), [contenteditable], [role="menu"], [role="listbox"], dialog';

/** Until the next frame a dialog that has just been closed has the focus still: nobody types there. */
export const isTyping = (target: EventTarget | null) =>
  target instanceof Element &&
  target.closest(typing) !== null &&
  target.closest("dialog:not([open])") === null;

/** The second key of two belongs to the first for so long. */
const sequenceMs = 2000;

/** Listens to the keys for as long as the page lives. */
export function startShortcuts(store: Store) {
  let first = { key: "", at: 0 };
  addEventListener("keydown", (event) => {
    const { key, target, timeStamp } = event;
    const isAlone = !(event.ctrlKey || event.metaKey || event.altKey);
    if (shortcuts.peek() === "off" || event.defaultPrevented || !isAlone || isTyping(target))
      return;
    const isSecond = timeStamp - first.at < sequenceMs;
    const sequence = isSecond && first.key !== "" ? `${first.key} ${key}` : key;
    const startsOne = table.some(({ keys }) =>
      keys.some((keys) => keys.startsWith(`${sequence} `)),
    );
    first = { key: startsOne ? sequence : "", at: timeStamp };
    const found = table.find(({ keys }) => keys.includes(sequence));
    if (found === undefined) return;
    event.preventDefault();
    const words = found.act(store);
    if (words !== undefined) announce(words);
  });
}
