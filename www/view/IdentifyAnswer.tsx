// What is known of the library: a sentence, and the seven choices with the values that are left.
import type { BehaviourAxis, IdentifyReport } from "../engine.ts";
import type { Store } from "../state.ts";
import { Copy } from "./Copy.tsx";
import { ContradictionWords } from "./IdentifyContradiction.tsx";
import { sentenceId } from "./IdentifySheet.tsx";
import type { Answer } from "./identify_answer.ts";
import {
  choicesOfLibrary,
  choicesOfUse,
  choiceWords,
  listed,
  type ValueWords,
} from "./identify_words.ts";

export const answerId = "identify-answer";

export function AnswerCard({ store, answer }: { store: Store; answer: Answer }) {
  const { report, shown, age } = answer;
  const name = store.state.value.libraryName.trim() || "The library";
  return (
    <section class={`card answer ${age === "current" ? "" : "aged"}`} aria-labelledby={answerId}>
      <header>
        <h2 id={answerId} tabIndex={-1}>
          <span class="long-name">{name}</span>
        </h2>
        <p class="left">{behavioursLeft(shown.possible)}</p>
      </header>
      {report.contradiction && <ContradictionWords store={store} found={report.contradiction} />}
      <AgeWords answer={answer} />
      <div class="answer-body">
        <Choices report={shown} />
        <div class="sentence">
          <p id={sentenceId} tabIndex={-1}>
            {shown.sentence}
          </p>
          <Copy of="the sentence for an issue" text={shown.sentence} />
        </div>
      </div>
    </section>
  );
}

export function behavioursLeft(possible: number): string {
  return possible === 1 ? "1 of 128 behaviours is left" : `${possible} of 128 behaviours are left`;
}

/** Where the answer is not that of all observations. */
function AgeWords({ answer: { age, uncounted, report } }: { answer: Answer }) {
  const numbers = listed(uncounted.map((at) => String(at + 1)));
  const which = `observation${uncounted.length === 1 ? "" : "s"} ${numbers}`;
  const doubtful = report.contradiction ? "the contradiction" : `the change of ${which}`;
  if (age === "old") {
    return <p class="old-result">What stands below is the last result, from before {doubtful}.</p>;
  }
  if (age === "of-others") {
    return <p class="old-result">What stands below is what the other observations say.</p>;
  }
  return uncounted.length === 0 ? null : (
    <p class="old-result">
      Not counted: {which}, which {uncounted.length === 1 ? "tells" : "tell"} nothing yet.
    </p>
  );
}

/** Both values of each choice side by side: settled, possible or ruled out. */
function Choices({ report }: { report: IdentifyReport }) {
  return (
    <table class="choices">
      <caption>
        <span class="visually-hidden">The seven choices and the values that are left. </span>
        <var>R</var>(<var>q</var>) is Hamilton's matrix, and <var>C</var>(<var>q</var>) its
        transpose.
      </caption>
      <ChoiceRows title="What it does" choices={choicesOfLibrary} report={report} />
      <ChoiceRows title="How it is used" choices={choicesOfUse} report={report} />
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
        <td>
          {settled} of {choices.length} settled
        </td>
      </tr>
      {choices.map((choice) => {
        const left: readonly string[] = report.remaining[choice];
        const values: readonly ValueWords[] = choiceWords[choice].values;
        return (
          <tr key={choice}>
            <th scope="row">{choiceWords[choice].name}</th>
            {values.map((value) => (
              <ValueCell
                key={value.value}
                words={value}
                standing={
                  !left.includes(value.value) ? "out" : left.length > 1 ? "open" : "settled"
                }
              />
            ))}
          </tr>
        );
      })}
    </tbody>
  );
}

const standingWords = { settled: "settled: ", open: "possible: ", out: "ruled out: " } as const;
const standingMarks = { settled: "✓", open: "?", out: "✕" } as const;

function ValueCell({
  words: { words, preset },
  standing,
}: {
  words: ValueWords;
  standing: keyof typeof standingWords;
}) {
  return (
    <td class={`value ${standing} ${preset ?? "custom"}`}>
      <span class="visually-hidden">{standingWords[standing]}</span>
      <span class="value-words">{words}</span>
      <span class="value-mark" aria-hidden="true">
        {standingMarks[standing]}
      </span>
    </td>
  );
}
