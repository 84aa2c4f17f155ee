// What is asked: text fields and the declared convention.
import type { ComponentChildren } from "preact";
import { choicesOfProblem, fixOfProblem } from "../../action/fixes.ts";
import { readOn } from "../../action/read_on.ts";
import type { Problem } from "../../engine.ts";
import type { Freshness, Store } from "../../state/store.ts";
import { symbolOf } from "../../words/conventions.ts";
import { retryWord } from "../../words/frame/loading.tsx";
import { shortAddressWords } from "../../words/parts/ask.tsx";
import { problemWords } from "../../words/parts/notes.tsx";
import { MoreAxes } from "./MoreAxes.tsx";
import { FixButton } from "./Notes.tsx";
import { NumberSettings } from "./NumberSettings.tsx";
import { problemId, TextField } from "./TextField.tsx";
import "./ask.css";

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
      <div class="ask-line">
        <TextField store={store} field="vector" />
        <NumberSettings store={store} />
        {examples}
      </div>
      <MoreAxes store={store} />
      <AskStatus store={store} freshness={freshness}>
        {children}
      </AskStatus>
    </>
  );
}

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
  if (store.isReading.value) {
    return (
      <div class="ask-status">
        <p class="reading">{problemWords.reading}</p>
      </div>
    );
  }
  return (
    <div class="ask-status">
      {problems.length === 0 && children}
      {store.addressed.value !== store.state.value && (
        <p class="address-words">{shortAddressWords}</p>
      )}
      {problems.map((problem, at) => {
        const Words = problem.message === "" ? UnsaidProblem : ProblemWords;
        return (
          <Words key={problem.field} store={store} problem={problem}>
            {at === 0 && (
              <span class="old-result">
                {freshness === "opening" ? problemWords.opening : problemWords.old}
              </span>
            )}
          </Words>
        );
      })}
    </div>
  );
}

interface ProblemProps {
  store: Store;
  problem: Problem;
  /** What stands at the end of its first line. */
  children: ComponentChildren;
}

/** A problem of the first core, where the whole one, which has the words for it, did not come. */
function UnsaidProblem({ store, problem: { field, code }, children }: ProblemProps) {
  return (
    <div class="problem" id={problemId(field)}>
      <p class="problem-head">
        <span class="problem-message">
          <var>{symbolOf[field]}</var>: {problemWords.unsaid(code)}.
        </span>{" "}
        {children}
      </p>
      <p class="problem-help">
        <span>{problemWords.missing}</span>
        <button type="button" class="quiet" onClick={() => readOn(store)}>
          {retryWord}
        </button>
      </p>
    </div>
  );
}

/** A problem, what was expected, and what to do: by hand, or with the button that does it. */
function ProblemWords({
  store,
  problem: { field, message, expected, hint },
  children,
}: ProblemProps) {
  const fix = fixOfProblem(store, field);
  const fixes = [...(fix ? [fix] : []), ...choicesOfProblem(store, field)];
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
          <span class={fixes.length > 0 ? "problem-by-hand" : undefined}>
            <span class="problem-key">{problemWords.try}</span> {hint}.
          </span>
        </span>
        {fixes.map((fix) => (
          <FixButton key={`${fix.label} ${fix.text}`} store={store} field={field} fix={fix} />
        ))}
      </p>
    </div>
  );
}
