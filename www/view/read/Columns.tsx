// Hamilton and JPL beside each other; where there is room for one, a switch says which.
import { useState } from "preact/hooks";
import type { ReadReport } from "../../engine.ts";
import { presetOf } from "../../model/conventions.ts";
import { type Digits, type Preset, presetChoices } from "../../model/page_state.ts";
import type { Store } from "../../state/store.ts";
import { wordsOf } from "../../words/conventions.ts";
import * as words from "../../words/read/column.ts";
import { Choice } from "../parts/Choice.tsx";
import { CaseLinks } from "./CaseLinks.tsx";
import { ConventionColumn } from "./Column.tsx";

export function Columns({
  report,
  store,
  declared,
  digits,
}: {
  report: ReadReport;
  store: Store;
  declared: Preset | undefined;
  digits: Digits;
}) {
  const [asked, ask] = useState<{ shown: Preset; declared: Preset | undefined }>();
  // Who declares another convention sees that one.
  if (asked && asked.declared !== declared) ask(undefined);
  const shown = asked?.shown ?? presetOf[report.quaternion.convention.handedness];
  return (
    <div class={`columns columns-of-${shown}`}>
      <Choice
        kind="choice"
        group="column"
        legend={words.shownColumn}
        values={presetChoices.map((preset) => ({
          value: preset,
          words: <span>{wordsOf[preset].name}</span>,
        }))}
        chosen={shown}
        choose={(preset) => ask({ shown: preset, declared })}
      />
      {presetChoices.map((preset) => (
        <ConventionColumn
          key={preset}
          store={store}
          preset={preset}
          declared={declared}
          column={report[preset]}
          digits={digits}
        />
      ))}
      <CaseLinks report={report} store={store} />
    </div>
  );
}
