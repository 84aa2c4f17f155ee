// The list of keys, from the table that acts on them, and whether they act.
import { Fragment } from "preact";
import { table } from "../../action/shortcuts.ts";
import { shortcutChoices, themes } from "../../model/settings.ts";
import type { ShortcutName } from "../../model/shortcut_name.ts";
import { chooseShortcuts, chooseTheme, shortcuts, theme } from "../../state/settings.ts";
import {
  innerKeys,
  orWord,
  remembered,
  shortcutWords,
  thenWord,
  whereTheyAct,
} from "../../words/frame/help.ts";
import { shortcutsLabel, shortcutsWords, themeLabel, themeWords } from "../../words/settings.ts";
import { SettingChoice } from "../parts/SettingChoice.tsx";
import "./help.css";

/** Those with a modifier act in text fields too; undo_by_key.ts and the fields listen to them. */
const everywhere: readonly { name: ShortcutName; keys: readonly string[] }[] = [
  { name: "undo", keys: ["Ctrl+Z"] },
  { name: "redo", keys: ["Ctrl+Shift+Z"] },
  { name: "mend", keys: ["Alt+Enter"] },
];

export function Help() {
  return (
    <>
      <KeyList
        rows={[...table, ...everywhere].map(({ name, keys }) => ({
          keys,
          does: shortcutWords[name],
        }))}
      />
      <p>{whereTheyAct}</p>
      {innerKeys.map(({ heading, rows }) => (
        <Fragment key={heading}>
          <h3>{heading}</h3>
          <KeyList rows={rows} />
        </Fragment>
      ))}
      <div class="help-settings">
        <SettingChoice
          name="shortcuts"
          label={shortcutsLabel}
          choices={shortcutChoices}
          chosen={shortcuts.value}
          words={shortcutsWords}
          onChoose={chooseShortcuts}
        />
        <SettingChoice
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

function KeyList({ rows }: { rows: readonly { keys: readonly string[]; does: string }[] }) {
  return (
    <dl class="shortcuts">
      {rows.map(({ keys, does }) => (
        <div key={does}>
          <dt>
            {keys.map((sequence, at) => (
              <Fragment key={sequence}>
                {at > 0 && <span class="shortcut-or"> {orWord} </span>}
                <Keys sequence={sequence} />
              </Fragment>
            ))}
          </dt>
          <dd>{does}</dd>
        </div>
      ))}
    </dl>
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
