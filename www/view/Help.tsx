// The list of keys, from the table that acts on them, and whether they act.
import { Fragment } from "preact";
import {
  chooseShortcuts,
  chooseTheme,
  shortcutChoices,
  shortcuts,
  theme,
  themes,
} from "../settings.ts";
import { type ShortcutName, table } from "../shortcuts.ts";
import { orWord, remembered, shortcutWords, thenWord, whereTheyAct } from "../words/help.ts";
import { shortcutsLabel, shortcutsWords, themeLabel, themeWords } from "../words/settings.ts";
import { Choice } from "./Settings.tsx";

/** Those with a modifier act in text fields too; history.ts listens to them. */
const everywhere: readonly { name: ShortcutName; keys: readonly string[] }[] = [
  { name: "undo", keys: ["Ctrl+Z"] },
  { name: "redo", keys: ["Ctrl+Shift+Z"] },
  { name: "mend", keys: ["Alt+Enter"] },
];

export function Help() {
  return (
    <>
      <dl class="shortcuts">
        {[...table, ...everywhere].map(({ name, keys }) => (
          <div key={name}>
            <dt>
              {keys.map((sequence, at) => (
                <Fragment key={sequence}>
                  {at > 0 && <span class="shortcut-or"> {orWord} </span>}
                  <Keys sequence={sequence} />
                </Fragment>
              ))}
            </dt>
            <dd>{shortcutWords[name]}</dd>
          </div>
        ))}
      </dl>
      <p>{whereTheyAct}</p>
      <div class="help-settings">
        <Choice
          name="shortcuts"
          label={shortcutsLabel}
          choices={shortcutChoices}
          chosen={shortcuts.value}
          words={shortcutsWords}
          onChoose={chooseShortcuts}
        />
        <Choice
          name="theme"
          label={themeLabel}
          choices={themes}
          chosen={theme.value}
          words={themeWords}
          onChoose={chooseTheme}
        />
      </div>
      <p>{remembered}</p>
    </>
  );
}

function Keys({ sequence }: { sequence: string }) {
  return (
    <>
      {sequence.split(" ").map((key, at) => (
        <Fragment key={key}>
          {at > 0 && <span class="visually-hidden"> {thenWord} </span>}
          <kbd>{key}</kbd>
        </Fragment>
      ))}
    </>
  );
}
