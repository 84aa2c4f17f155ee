// The Identify view: which convention a library uses, from what it prints.
import { useMemo } from "preact/hooks";
import { toFragment } from "../../address/fragment.ts";
import type { Probe } from "../../engine.ts";
import { opening, type PageState } from "../../model/page_state.ts";
import type { Store } from "../../state/store.ts";
import { left } from "../../words/identify/answer.tsx";
import * as words from "../../words/identify/identify.tsx";
import { familyWords, languageNames } from "../../words/library_behaviour.ts";
import { AskedFold } from "../parts/AskedFold.tsx";
import { AnswerCard, answerId } from "./Answer.tsx";
import { codeLanguages } from "./choices.ts";
import { keptAnswer } from "./kept_answer.ts";
import { MatchingLibraries } from "./MatchingLibraries.tsx";
import { Meaning } from "./Meaning.tsx";
import { NumbersFold, spokenNumbers } from "./Numbers.tsx";
import { printedId } from "./Observation.tsx";
import { Sheet } from "./Sheet.tsx";
import "../parts/ask.css";
import "../parts/examples.css";
import "../parts/result.css";
import "./identify.css";

const loadMatrices = () => import("./Matrices.tsx").then(({ Matrices }) => Matrices);

export { askedOfIdentify } from "./asked.ts";

export function Identify({ store }: { store: Store }) {
  const kept = useMemo(() => keptAnswer(store), [store]);
  const answer = kept.value;
  if (answer === undefined) return <p class="left">{words.none}</p>;
  const name = store.state.value.libraryName.trim() || words.unnamed;
  const { shown, age } = answer;
  const { family } = shown;
  return (
    <>
      <Ask store={store} />
      <NumbersFold store={store} />
      <AskedFold store={store} name="matrices" summary={words.matrices} load={loadMatrices} />
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
          {left(shown.possible)}
        </span>
        <button
          type="button"
          class="quiet"
          onClick={() => {
            document.getElementById(answerId)?.scrollIntoView();
            document.getElementById(answerId)?.focus();
          }}
        >
          {words.seeAnswer}
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

const examples: {
  name: keyof typeof words.exampleNames;
  change: Pick<PageState, "observations" | "libraryName">;
}[] = [
  {
    name: "not-jpl",
    change: { observations: opening.observations, libraryName: opening.libraryName },
  },
  {
    name: "stored",
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
    name: "rounded",
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
    name: "formal",
    change: {
      observations: [
        product("0 0 0 1"),
        rotated("3 1 2"),
        matrix("0 0 1\n1 0 0\n0 1 0"),
        {
          probe: "perturb",
          quaternion: half,
          rotationVector: "0.1 0 0",
          printed: "0.474 0.524 0.474 0.524",
        },
        { probe: "quarter-turn", printed: "0.707 0 0 -0.707" },
      ],
      libraryName: "X",
    },
  },
  {
    name: "contradiction",
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
    <section class="ask identify-ask" aria-label={words.input}>
      <div class="ask-row">
        <p class="identify-lead">{words.lead}</p>
        <button
          type="button"
          class="start"
          onClick={() => {
            store.set(empty);
            requestAnimationFrame(() => document.getElementById(printedId(0))?.focus());
          }}
        >
          {words.start}
        </button>
      </div>
      <div class="ask-row">
        <label class="plain-field">
          {words.library}
          <input
            class="plain-input"
            type="text"
            value={state.libraryName}
            autocomplete="off"
            spellcheck={false}
            onInput={(event) => store.set({ libraryName: event.currentTarget.value })}
          />
        </label>
        <label class="plain-field">
          {words.code}
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
          <span id="identify-examples">{words.examples}</span>
          <ul aria-labelledby="identify-examples">
            {examples.map(({ name, change }) => {
              const there = { ...change, unavailable: [] };
              return (
                <li key={name}>
                  <a
                    href={`#${toFragment({ ...state, ...there })}`}
                    aria-current={isEqual(state, there) ? "true" : undefined}
                  >
                    {words.exampleNames[name]}
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
  return [spokenNumbers(store), spokenLibrary(store)].filter((words) => words !== "").join(" ");
}

function spokenLibrary(store: Store): string {
  const report = store.identify.value?.report;
  if (report === undefined) return "";
  const problems = report.observations.flatMap((observation, at) => {
    if (observation.status === "unexplained") {
      return [words.spokenUnexplained(at)];
    }
    if (observation.status !== "problem") return [];
    return [words.spokenProblem(at, observation.problem)];
  });
  if (problems.length > 0) return problems.join(" ");
  const { contradiction, possible, sentence } = report;
  return contradiction
    ? words.spokenContradiction(contradiction)
    : words.spokenAnswer(possible, sentence);
}
