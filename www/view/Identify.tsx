// The Identify view: which convention a library uses, from what it prints.
import { useMemo } from "preact/hooks";
import { opening, type PageState, toFragment } from "../address.ts";
import type { Probe } from "../engine.ts";
import type { Store } from "../state.ts";
import { AnswerCard, answerId, behavioursLeft } from "./IdentifyAnswer.tsx";
import { MatchingLibraries } from "./IdentifyLibraries.tsx";
import { Meaning } from "./IdentifyMeaning.tsx";
import { printedId } from "./IdentifyObservation.tsx";
import { Sheet } from "./IdentifySheet.tsx";
import { keptAnswer } from "./identify_answer.ts";
import { choiceWords, codeLanguages, listed, settledFamily } from "./identify_words.ts";
import { familyWords, languageNames } from "./library_words.ts";
import "./picker.css";
import "./translate.css";
import "./libraries.css";
import "./identify.css";
import "./identify_answer.css";

export function Identify({ store }: { store: Store }) {
  const kept = useMemo(() => keptAnswer(store), [store]);
  const answer = kept.value;
  if (answer === undefined) return <p class="left">No answer yet.</p>;
  const name = store.state.value.libraryName.trim() || "The library";
  const { shown, age } = answer;
  const family = settledFamily(shown.remaining);
  return (
    <>
      <Ask store={store} />
      <div class="identify">
        <Sheet store={store} answer={answer} isExample={isExample(store.state.value)} />
        <AnswerCard store={store} answer={answer} />
      </div>
      <div class={`result ${age === "current" ? "current" : "old"}`}>
        <Meaning report={shown} name={name} />
        <MatchingLibraries store={store} report={shown} />
      </div>
      <p class="progress">
        <span>
          {family && <strong>{familyWords[family][0]}. </strong>}
          {behavioursLeft(shown.possible)}
        </span>
        <button
          type="button"
          class="quiet"
          onClick={() => {
            document.getElementById(answerId)?.scrollIntoView();
            document.getElementById(answerId)?.focus();
          }}
        >
          See the answer
        </button>
      </p>
    </>
  );
}

const half = "0.5 0.5 0.5 0.5";
const product = (printed: string): Probe => ({
  probe: "product",
  a: "0 1 0 0",
  b: "0 0 1 0",
  printed,
});
const rotated = (printed: string): Probe => ({
  probe: "rotate",
  quaternion: half,
  vector: "1 2 3",
  printed,
});
const matrix = (printed: string): Probe => ({
  probe: "matrix",
  quaternion: half,
  printed,
  layout: "as-written",
});

/** What libraries print, one example of each surprise. */
const examples: { name: string; change: Pick<PageState, "observations" | "libraryName"> }[] = [
  {
    name: "ij = −k and yet not JPL",
    change: { observations: opening.observations, libraryName: opening.libraryName },
  },
  {
    name: "Hamilton, stored x y z w",
    change: {
      observations: [
        product("[1. 0. 0. 0.]"),
        rotated("[3. 1. 2.]"),
        matrix("[[0. 0. 1.]\n [1. 0. 0.]\n [0. 1. 0.]]"),
      ],
      libraryName: "X",
    },
  },
  {
    name: "Rounded, and −q",
    change: {
      observations: [
        product("0 0 0 1"),
        rotated("2.0000 3.0000 1.0000"),
        { probe: "quarter-turn", printed: "-0.7071 0 0 -0.7071" },
      ],
      libraryName: "X",
    },
  },
  {
    name: "A contradiction",
    change: {
      observations: [
        product("0 0 0 1"),
        rotated("3 1 2"),
        { probe: "product", a: "0 0 1 0", b: "0 1 0 0", printed: "0 0 0 1" },
      ],
      libraryName: "X",
    },
  },
];

function isEqual(state: PageState, change: Partial<PageState>): boolean {
  return toFragment(state) === toFragment({ ...state, ...change });
}

const isExample = (state: PageState) =>
  examples.some(({ change }) => isEqual(state, { ...change, unavailable: [] }));

/** The name, the language, and where to begin. */
function Ask({ store }: { store: Store }) {
  const state = store.state.value;
  const empty = { observations: [], libraryName: "", unavailable: [] };
  const chosen = state.language === "message" ? "python" : state.language;
  return (
    <section class="ask identify-ask" aria-label="Input">
      <div class="ask-row">
        <p class="identify-lead">
          Which convention does this library use? Three short lines of code are usually enough to
          tell.
        </p>
        <button
          type="button"
          class="start"
          onClick={() => {
            store.set(empty);
            requestAnimationFrame(() => document.getElementById(printedId(0))?.focus());
          }}
        >
          Start with an empty sheet
        </button>
      </div>
      <div class="ask-row">
        <label class="plain-field">
          Library
          <input
            type="text"
            value={state.libraryName}
            autocomplete="off"
            spellcheck={false}
            onInput={(event) => store.set({ libraryName: event.currentTarget.value })}
          />
        </label>
        <label class="plain-field">
          Code in
          <select
            value={chosen}
            onChange={(event) => {
              const language = codeLanguages.find((name) => name === event.currentTarget.value);
              if (language) store.set({ language });
            }}
          >
            {codeLanguages.map((language) => (
              <option key={language} value={language}>
                {languageNames[language]}
              </option>
            ))}
          </select>
        </label>
        <div class="examples">
          <span id="identify-examples">Examples</span>
          <ul aria-labelledby="identify-examples">
            {examples.map(({ name, change }) => {
              const there = { ...change, unavailable: [] };
              return (
                <li key={name}>
                  <a
                    href={`#${toFragment({ ...state, ...there })}`}
                    aria-current={isEqual(state, there) ? "true" : undefined}
                  >
                    {name}
                  </a>
                </li>
              );
            })}
          </ul>
        </div>
      </div>
    </section>
  );
}

/** What a screen reader hears when the result changes. */
export function spokenIdentity(store: Store): string {
  const report = store.identify.value?.report;
  if (report === undefined) return "";
  const problems = report.observations.flatMap((observation, at) => {
    if (observation.status === "unexplained") {
      return [`Observation ${at + 1}: no behaviour prints this.`];
    }
    if (observation.status !== "problem") return [];
    const { message, expected, hint } = observation.problem;
    return [`Problem in observation ${at + 1}: ${message}. Expected ${expected}. Try ${hint}.`];
  });
  if (problems.length > 0) return problems.join(" ");
  const { contradiction, possible, sentence } = report;
  if (contradiction) {
    const numbers = contradiction.observations.map((at) => String(at + 1));
    const about = contradiction.about.map((choice) => choiceWords[choice].about);
    const disagree = about.length > 0 ? ` They disagree about ${listed(about)}.` : "";
    return `Observations ${listed(numbers)} contradict each other.${disagree}`;
  }
  return `${behavioursLeft(possible)}. ${sentence}`;
}
