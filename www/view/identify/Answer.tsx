// What is known of the library: a sentence, and the eight choices with the values that are left.
import type { BehaviourAxis, IdentifyReport } from "../../engine.ts";
import { choicesOfLibrary, choicesOfUse, presetOfValue, valuesOf } from "../../model/behaviour.ts";
import type { Store } from "../../state/store.ts";
import * as words from "../../words/identify/answer.tsx";
import { choiceWords } from "../../words/identify/choices.ts";
import { unnamed } from "../../words/identify/identify.tsx";
import { Copy } from "../parts/Copy.tsx";
import { ContradictionWords } from "./Contradiction.tsx";
import { wordsOfValue } from "./choices.ts";
import type { Answer } from "./kept_answer.ts";
import { sentenceId } from "./Sheet.tsx";
import { TranslateFrom } from "./TranslateFrom.tsx";
import "../parts/result.css";
import "./answer.css";

export const answerId = "identify-answer";

export function AnswerCard({ store, answer }: { store: Store; answer: Answer }) {
  const { report, shown, age } = answer;
  const name = store.state.value.libraryName.trim() || unnamed;
  return (
    <section class={`card answer ${age === "current" ? "" : "aged"}`} aria-labelledby={answerId}>
      <header>
        <h2 id={answerId} tabIndex={-1}>
          <span class="long-name">{name}</span>
        </h2>
        <p class="left">{words.left(shown.possible)}</p>
      </header>
      {report.contradiction && <ContradictionWords store={store} found={report.contradiction} />}
      <AgeWords answer={answer} />
      <div class="answer-body">
        <Choices report={shown} />
        <div class="sentence">
          <p id={sentenceId} tabIndex={-1}>
            {shown.sentence}
          </p>
          <Copy of={words.copied} text={shown.sentence} />
        </div>
        <TranslateFrom store={store} report={shown} />
      </div>
    </section>
  );
}

/** Where the answer is not that of all observations. */
function AgeWords({ answer: { age, uncounted, report } }: { answer: Answer }) {
  const sayOf = () => {
    if (age === "of-others") return words.ofOthers;
    if (age === "current") return uncounted.length > 0 && words.uncounted(uncounted);
    return report.contradiction ? words.fromBeforeContradiction : words.fromBeforeChange(uncounted);
  };
  const said = sayOf();
  return said ? <p class="old-result">{said}</p> : null;
}

/** Both values of each choice side by side: settled, possible or ruled out. */
function Choices({ report }: { report: IdentifyReport }) {
  return (
    <table class="choices">
      <caption>{words.choices}</caption>
      <ChoiceRows title={words.ofLibrary} choices={choicesOfLibrary} report={report} />
      <ChoiceRows title={words.ofUse} choices={choicesOfUse} report={report} />
    </table>
  );
}

function ChoiceRows({
  title,
  choices,
  report,
}: {
  title: string;
  choices: readonly BehaviourAxis[];
  report: IdentifyReport;
}) {
  const settled = choices.filter((choice) => report.settled.includes(choice)).length;
  return (
    <tbody>
      <tr class="choices-title">
        <th scope="colgroup" colSpan={2}>
          {title}
        </th>
        <td>{words.settled(settled, choices.length)}</td>
      </tr>
      {choices.map((choice) => {
        const left: readonly string[] = report.remaining[choice];
        return (
          <tr key={choice}>
            <th scope="row">{choiceWords[choice].name}</th>
            {valuesOf[choice].map((value) => (
              <ValueCell
                key={value}
                choice={choice}
                value={value}
                standing={!left.includes(value) ? "out" : left.length > 1 ? "open" : "settled"}
              />
            ))}
          </tr>
        );
      })}
    </tbody>
  );
}

const standingMarks = { settled: "✓", open: "?", out: "✕" } as const;

function ValueCell({
  choice,
  value,
  standing,
}: {
  choice: BehaviourAxis;
  value: string;
  standing: keyof typeof standingMarks;
}) {
  return (
    <td class={`value ${standing} ${presetOfValue[value] ?? "custom"}`}>
      <span class="visually-hidden">{words.standing[standing]}</span>
      <span class="value-words">{wordsOfValue(choice, value)}</span>
      <span class="value-mark" aria-hidden="true">
        {standingMarks[standing]}
      </span>
    </td>
  );
}
