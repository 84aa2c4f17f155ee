// The sheet: what was observed, the question that the core asks next, and what else can be tried.
import type { IdentifyReport, NextProbe, Probe, ProbeKind } from "../../engine.ts";
import { choicesOfLibrary } from "../../model/behaviour.ts";
import { isSameProbe, kinds, mostObservations } from "../../model/probes.ts";
import type { Store } from "../../state/store.ts";
import { probeWords } from "../../words/identify/choices.ts";
import * as words from "../../words/identify/sheet.tsx";
import type { Answer } from "./kept_answer.ts";
import { Observation, printedId } from "./Observation.tsx";
import "../parts/result.css";
import "./sheet.css";

/** Where the answer can be reached from the last question. */
export const sentenceId = "identify-sentence";

function focus(id: string) {
  document.getElementById(id)?.focus();
}

/** After the change is on the page. */
function focusSoon(id: string) {
  requestAnimationFrame(() => focus(id));
}

export function Sheet({
  store,
  answer,
  isExample,
}: {
  store: Store;
  answer: Answer;
  isExample: boolean;
}) {
  const { observations } = store.state.value;
  const { report } = answer;
  const disagreeing = report.contradiction?.observations ?? [];
  const question = questionAfter(observations, answer);
  const put = (at: number, probe: Probe) =>
    store.set({
      observations: [...observations.slice(0, at), probe, ...observations.slice(at + 1)],
    });
  const moveOn = (at: number) => {
    const next = document.getElementById(printedId(at + 1)) ? printedId(at + 1) : sentenceId;
    focus(next);
  };
  const remove = (at: number) => {
    store.set({ observations: observations.filter((_, other) => other !== at) });
    focusSoon(printedId(Math.min(at, Math.max(0, observations.length - 2))));
  };
  // A question that is being answered becomes an observation at its place: one list, so that the
  // field keeps the focus.
  const cards = [...observations, ...(question ? [question.probe as Probe] : [])];
  return (
    <section class="sheet" aria-labelledby="sheet-name">
      <header class="sheet-head">
        <h2 id="sheet-name">{words.title}</h2>
        {isExample && <span class="badge">{words.example}</span>}
        <p>{words.lead}</p>
      </header>
      <ol class="observations">
        {cards.map((probe, at) => {
          const isQuestion = at === observations.length;
          return (
            <Observation
              key={at}
              at={at}
              probe={probe}
              report={report.observations[at]}
              code={isQuestion ? question?.code : report.codes[at]}
              isQuestion={isQuestion}
              lead={isQuestion ? leadTo(report) : undefined}
              contradicts={
                disagreeing.includes(at) ? disagreeing.filter((other) => other !== at) : []
              }
              onChange={(changed) => put(at, changed)}
              onDone={() => moveOn(at)}
              button={
                isQuestion ? (
                  <CannotRun store={store} kind={probe.probe} at={at} />
                ) : (
                  <button type="button" class="quiet" onClick={() => remove(at)}>
                    {words.remove(at)}
                  </button>
                )
              }
            />
          );
        })}
      </ol>
      {!question && <NoQuestion store={store} answer={answer} />}
      <Unavailable store={store} />
      <Add store={store} />
    </section>
  );
}

/** The question of the core, unless it already stands in the list without an answer. */
function questionAfter(observations: readonly Probe[], { report }: Answer): NextProbe | undefined {
  const { next } = report;
  if (next === undefined || observations.length >= mostObservations) return undefined;
  const isOpen = observations.some(
    (probe, at) => report.observations[at]?.status !== "told" && probe.probe === next.probe.probe,
  );
  return isOpen ? undefined : next;
}

/** Said when the rest is for those who need it. */
function leadTo({ settled }: IdentifyReport): string | undefined {
  return choicesOfLibrary.every((choice) => settled.includes(choice)) ? words.settled : undefined;
}

function CannotRun({ store, kind, at }: { store: Store; kind: ProbeKind; at: number }) {
  const { unavailable } = store.state.value;
  return (
    <button
      type="button"
      class="quiet"
      onClick={() => {
        store.set({ unavailable: [...unavailable, kind] });
        focusSoon(printedId(at));
      }}
    >
      {words.cannotRun}
    </button>
  );
}

/** Why nothing is asked. */
function NoQuestion({ store, answer: { report } }: { store: Store; answer: Answer }) {
  const { observations, unavailable } = store.state.value;
  return <p class="no-question">{reason()}</p>;

  function reason(): string {
    if (report.contradiction) return words.questionAfterContradiction;
    const open = observations.findIndex((probe, at) => {
      const isOpen = report.observations[at]?.status !== "told";
      return isOpen && probe.probe === report.next?.probe.probe;
    });
    if (open >= 0) return words.questionAfter(open);
    if (report.next) return words.full(mostObservations);
    if (report.possible === 1) return words.allSettled;
    return unavailable.length > 0 ? words.noneToRun : words.noneTellsMore;
  }
}

/** What the visitor cannot run, and how to take that back. */
function Unavailable({ store }: { store: Store }) {
  const { observations, unavailable } = store.state.value;
  if (unavailable.length === 0) return null;
  const askAgain = () => {
    store.set({ unavailable: [] });
    focusSoon(printedId(observations.length));
  };
  return (
    <p class="unavailable">
      {words.notAsked(unavailable.map((kind) => probeWords[kind].name))}{" "}
      <button type="button" class="quiet" onClick={askAgain}>
        {words.askAgain}
      </button>
    </p>
  );
}

/** Any probe, in any order. */
function Add({ store }: { store: Store }) {
  const { observations } = store.state.value;
  const standardOf = (kind: ProbeKind) =>
    store.engine.standardProbes.find(({ probe }) => probe === kind);
  const add = (kind: ProbeKind) => {
    const standard = standardOf(kind);
    if (standard === undefined) return;
    store.set({ observations: [...observations, standard] });
    focusSoon(printedId(observations.length));
  };
  const isTried = (kind: ProbeKind) => {
    const standard = standardOf(kind);
    return standard !== undefined && observations.some((probe) => isSameProbe(probe, standard));
  };
  return (
    <fieldset class="add" disabled={observations.length >= mostObservations}>
      <legend>{words.add}</legend>
      {kinds.map((kind) => (
        <button key={kind} type="button" class="chip" onClick={() => add(kind)}>
          {probeWords[kind].name}
          {isTried(kind) && <span class="visually-hidden">{words.onceMore}</span>}
        </button>
      ))}
    </fieldset>
  );
}
