// What is asked: text fields and the declared convention.
import type { ComponentChildren } from "preact";
import { useId } from "preact/hooks";
import type { Preset } from "../address.ts";
import type { Field, Problem } from "../engine.ts";
import { applyFirst, fixOfProblem, type TextName } from "../fixes.ts";
import { declaredConvention, type Freshness, type Store } from "../state.ts";
import * as words from "../words/ask.ts";
import { symbolOf, wordsOf } from "../words/conventions.ts";
import { problemWords } from "../words/notes.tsx";
import { MoreAxes } from "./Axes.tsx";
import { fiveWords, nameOf } from "./conventions.ts";
import { MarkedText } from "./MarkedText.tsx";
import { FixButton } from "./Notes.tsx";
import { NumberSettings } from "./Settings.tsx";

/** The texts that a view is about. */
const heroes: readonly Field[] = ["quaternion", "p", "q"];

/** A field for text in any form, with the place of a problem marked in the text itself. */
export function TextField({
  store,
  field,
  name = field as TextName,
  label = field === "vector" ? words.vector : words.quaternion,
}: {
  store: Store;
  /** As the core names it in a problem. */
  field: Field;
  /** As the state names it. */
  name?: TextName;
  label?: string;
}) {
  const id = useId();
  const text = store.state.value[name];
  const problem = store.problemOf(field);
  return (
    <div class={`field ${heroes.includes(field) ? "field-hero" : "field-plain"}`}>
      <div class="field-box" data-field={field}>
        <label for={id} class="field-label">
          <span class="visually-hidden">{label}</span>
          <var>{symbolOf[field]}</var>
        </label>
        <MarkedText
          id={id}
          name={name}
          text={text}
          problem={problem}
          describedBy={problem && problemId(field)}
          onInput={(typed) => store.set({ [name]: typed })}
          onAltEnter={() => applyFirst(store, field)}
        />
      </div>
    </div>
  );
}

/** What is asked beside the rotations: the vector, the decimals, the axes; and what is said of all. */
export function AskRest({
  store,
  freshness,
  examples,
  children,
}: {
  store: Store;
  /** Of the result below. */
  freshness: Freshness | undefined;
  examples?: ComponentChildren;
  /** How the texts were read. */
  children: ComponentChildren;
}) {
  return (
    <>
      <div class="ask-row">
        <TextField store={store} field="vector" />
        <NumberSettings store={store} />
      </div>
      {examples}
      <MoreAxes store={store} />
      <AskStatus store={store} freshness={freshness}>
        {children}
      </AskStatus>
    </>
  );
}

const problemId = (field: Field) => `problem-${field}`;

/**
 * What is said about the texts: how they were read, or what stands in the way. One place for both,
 * so that nothing moves while a text is typed.
 */
export function AskStatus({
  store,
  freshness,
  children,
}: {
  store: Store;
  /** Of the result below. */
  freshness: Freshness | undefined;
  children: ComponentChildren;
}) {
  const problems = store.problems.value;
  return (
    <div class="ask-status">
      {problems.length === 0
        ? children
        : problems.map((problem, at) => (
            <ProblemWords key={problem.field} store={store} problem={problem}>
              {at === 0 && (
                <span class="old-result">
                  {freshness === "opening" ? problemWords.opening : problemWords.old}
                </span>
              )}
            </ProblemWords>
          ))}
    </div>
  );
}

/** A problem, what was expected, and what to do: by hand, or with the button that does it. */
function ProblemWords({
  store,
  problem: { field, message, expected, hint, suggestion },
  children,
}: {
  store: Store;
  problem: Problem;
  /** What stands at the end of its first line. */
  children: ComponentChildren;
}) {
  const fix = fixOfProblem(store, field);
  return (
    <div class="problem" id={problemId(field)}>
      <p class="problem-head">
        <span class="problem-message">
          <var>{symbolOf[field]}</var>: <bdi>{message}</bdi>.
        </span>{" "}
        {children}
      </p>
      <p class="problem-help">
        <span>
          <span class="problem-key">{problemWords.expected}</span> {expected}.{" "}
          <span class={fix && "problem-by-hand"}>
            <span class="problem-key">{problemWords.try}</span> {hint}.
          </span>
        </span>
        {fix && (
          <FixButton store={store} field={field} fix={fix}>
            <code class="fix-text">{suggestion?.text}</code>
          </FixButton>
        )}
      </p>
    </div>
  );
}

const presets: Preset[] = ["hamilton", "jpl"];

/** Declares how the text is meant. */
export function ConventionSwitch({ store }: { store: Store }) {
  const state = store.state.value;
  const convention = declaredConvention(state, store.engine);
  const isPreset = Object.keys(state.axes).length === 0;
  const chosen = isPreset ? state.preset : undefined;
  return (
    <fieldset class="switch">
      <legend class="visually-hidden">{words.meantAs}</legend>
      {presets.map((preset) => (
        <label key={preset} class={`switch-choice ${preset}`}>
          <input
            type="radio"
            name="convention"
            value={preset}
            checked={preset === chosen}
            onChange={() => store.set({ preset, axes: {} })}
          />
          <span class="switch-name">{wordsOf[preset].name}</span>
          <span class="switch-meaning">{wordsOf[preset].meaning}</span>
        </label>
      ))}
      {!isPreset && (
        <label class="switch-choice custom">
          <input type="radio" name="convention" value="custom" checked />
          <span class="switch-name">{words.custom}</span>
          <span class="switch-meaning">
            {nameOf(convention, store.engine) ?? fiveWords(convention)}
          </span>
        </label>
      )}
    </fieldset>
  );
}
