// Which description of an attitude some numbers are: the question, folded, and its answer.
import { useEffect, useId, useState } from "preact/hooks";
import type { Field, NumbersReport, Problem, Reading } from "../../engine.ts";
import type { PageState } from "../../model/page_state.ts";
import { shownRoughAngle } from "../../number/format.ts";
import type { Store } from "../../state/store.ts";
import * as words from "../../words/identify/numbers.tsx";
import { problemOf } from "../../words/identify/observation.tsx";
import { capital } from "../../words/phrases.ts";
import { ConventionSwitch } from "../parts/ConventionSwitch.tsx";
import { MarkedText } from "../parts/MarkedText.tsx";
import "../parts/ask.css";
import "../parts/examples.css";
import "../parts/fold.css";
import "../parts/result.css";
import "../parts/text_field.css";
import { askedOfNumbers } from "./asked.ts";
import "./numbers.css";

type Asked = Pick<PageState, "numbers" | "beside">;

const examples: { name: keyof typeof words.exampleNames; asked: Asked }[] = [
  {
    name: "engine",
    asked: { numbers: "40.00, 335.00, 70.00", beside: "0.70904 0.15687 -0.35813 0.58685" },
  },
  {
    name: "rewriting",
    asked: { numbers: "(-q2, q1, -q4, q3)", beside: "0.70904 0.15687 -0.35813 0.58685" },
  },
  {
    name: "matrix",
    asked: {
      numbers: "0.137 1.800 1.730\n-2.361 0.655 -0.495\n-0.809 -1.607 1.736",
      beside: "0.70904 0.15687 -0.35813 0.58685",
    },
  },
];

/** As many of the readings are shown. */
const shownAtOnce = 4;

/** Folded until it is asked, or until a link asks it. */
export function NumbersFold({ store }: { store: Store }) {
  const { numbers } = store.state.value;
  const isAsked = numbers !== "";
  const [isOpen, setOpen] = useState(isAsked);
  useEffect(() => {
    if (isAsked) setOpen(true);
  }, [isAsked]);
  return (
    <details
      class="fold numbers-fold"
      open={isOpen}
      onToggle={({ currentTarget }) => {
        if (currentTarget.open && !isAsked) store.set({ ...examples[0]?.asked });
        setOpen(currentTarget.open);
      }}
    >
      <summary>{words.summary}</summary>
      {isOpen && <Numbers store={store} />}
    </details>
  );
}

function Numbers({ store }: { store: Store }) {
  const state = store.state.value;
  const answer = store.beside(askedOfNumbers).value;
  const problems = answer?.status === "problems" ? answer.problems : [];
  const answerId = useId();
  const field = (name: keyof Asked, of: Field) => (
    <Text
      label={name === "numbers" ? words.numbers : words.attitude}
      text={state[name]}
      problem={problems.find((problem) => problem.field === of)}
      describedBy={answerId}
      onInput={(typed) => store.set({ [name]: typed })}
    />
  );
  return (
    <section class="card" aria-label={words.summary}>
      <p class="numbers-lead">{words.lead}</p>
      <div class="numbers-texts">
        {field("numbers", "numbers")}
        {field("beside", "quaternion")}
      </div>
      <div class="ask-row">
        <ConventionSwitch store={store} />
        <Examples store={store} />
      </div>
      <div class="numbers-answer" id={answerId}>
        {answer?.status === "failure" && <p class="problem">{answer.message}</p>}
        {problems.map((problem) => (
          <p key={problem.field} class="problem">
            {problemOf(problem)}
          </p>
        ))}
        {answer?.status === "numbers" && <Readings store={store} report={answer} />}
      </div>
    </section>
  );
}

/** A field under its name, with the place of what is wrong with it. */
export function Text({
  label,
  text,
  problem,
  describedBy,
  onInput,
}: {
  label: string;
  text: string;
  problem: Problem | undefined;
  describedBy: string;
  onInput: (text: string) => void;
}) {
  const id = useId();
  return (
    <div class="field field-plain">
      <div class="field-box">
        <label for={id} class="field-label">
          {label}
        </label>
        <MarkedText
          id={id}
          text={text}
          problem={problem}
          describedBy={describedBy}
          onInput={onInput}
        />
      </div>
    </div>
  );
}

function Examples({ store }: { store: Store }) {
  const { numbers, beside } = store.state.value;
  return (
    <div class="examples">
      <span id="numbers-examples">{words.examples}</span>
      <ul aria-labelledby="numbers-examples">
        {examples.map(({ name, asked }) => (
          <li key={name}>
            <a
              href={store.linkTo(asked)}
              aria-current={
                asked.numbers === numbers && asked.beside === beside ? "true" : undefined
              }
            >
              {words.exampleNames[name]}
            </a>
          </li>
        ))}
      </ul>
    </div>
  );
}

/** The answer as a sentence, and the readings that come nearest. */
function Readings({ store, report }: { store: Store; report: NumbersReport }) {
  const { fitting, readings } = report;
  const shown = readings.slice(0, shownAtOnce);
  return (
    <>
      <p class="numbers-sentence">{sentenceOf(store, report)}</p>
      <table class="readings">
        <caption class="visually-hidden">{words.readings}</caption>
        <tbody>
          {shown.map((reading, at) => (
            <tr key={at} class={at < fitting ? "fits" : ""}>
              <th scope="row">{capital(words.readingWords(reading))}</th>
              <td>{at < fitting ? words.fits : words.off(rough(store, reading.offDeg))}</td>
              <td>
                <ReadLink store={store} reading={reading} />
              </td>
            </tr>
          ))}
        </tbody>
      </table>
    </>
  );
}

/** What a screen reader hears when the answer changes; nothing where nothing is asked. */
export function spokenNumbers(store: Store): string {
  const answer = store.beside(askedOfNumbers).value;
  if (answer?.status === "numbers") return sentenceOf(store, answer);
  if (answer?.status !== "problems") return "";
  return answer.problems.map(words.spokenProblem).join(" ");
}

/** What the numbers are, or why that is not known. */
function sentenceOf(store: Store, report: NumbersReport): string {
  const { fitting, readings, marginDeg } = report;
  const [first] = readings;
  if (first === undefined) return "";
  if (fitting === 0) return words.none(rough(store, first.offDeg));
  if (fitting > 1) {
    const isThree = !["quaternion", "matrix"].includes(first.meaning.kind);
    return isThree ? words.several(fitting) : words.severalOf(fitting);
  }
  const next = marginDeg === undefined ? undefined : rough(store, marginDeg);
  return words.only(words.readingWords(first), next);
}

const rough = (store: Store, degrees: number) => shownRoughAngle(degrees, store.state.value.unit);

/** The attitude of a reading, with Euler angles in its sequence. */
function ReadLink({ store, reading }: { store: Store; reading: Reading }) {
  const { text, meaning } = reading;
  if (text === undefined) return null;
  const euler = meaning.kind === "euler-angles" && { euler: meaning.sequence };
  return (
    <a
      href={store.linkTo({ view: "read", quaternion: text, ...euler })}
      aria-label={`${words.read}: ${words.readingWords(reading)}`}
    >
      {words.read}
    </a>
  );
}
