// The one mutable value of the page, and what follows from it.
import { batch, computed, type ReadonlySignal, signal } from "@preact/signals";
import {
  fromFragment,
  isOfNewerVersion,
  toFragment,
  withKnownLibraries,
} from "../address/fragment.ts";
import type { Engine, Field, Outcome, Problem, Request } from "../engine.ts";
import { declaredConvention } from "../model/conventions.ts";
import { opening, type PageState, smallViews, type View } from "../model/page_state.ts";
import { type Answer, addressed } from "./addressed.ts";
import { endAnnouncement } from "./announcement.ts";
import {
  type Content,
  changedParts,
  closed,
  type Doing,
  type Move,
  noHistory,
  recorded,
  redone,
  undone,
} from "./history.ts";

/** How a result relates to the texts above it: theirs, that of earlier texts, or the opening one. */
export type Freshness = "current" | "old" | "opening";

export interface Shown<Report> {
  report: Report;
  freshness: Freshness;
}

/**
 * What was typed into the numbers of one group of the result: the parts of every text that they gave.
 * It stands in the fields, instead of the numbers of the result, as long as the text is one of these.
 */
export interface Draft {
  group: string;
  parts: ReadonlyMap<string, readonly string[]>;
}

export type Store = ReturnType<typeof createStore>;

/** How numbers are shown where no link says it. */
type NumberLook = Partial<Pick<PageState, "digits" | "unit">>;

export function createStore(first: Engine, fragment: string, rememberedNumbers: () => NumberLook) {
  const engine = signal(first);
  const isLibrary = computed(() => knownBy(engine.value));
  // A link gives the same page everywhere; a bare address shows numbers as they were last chosen.
  const stateOf = (fragment: string): PageState => ({
    ...fromFragment(fragment, isLibrary.peek()),
    ...(fragment.replace(/^#/, "") === "" && rememberedNumbers()),
  });
  const state = signal<PageState>(stateOf(fragment));
  const isLinkNewer = signal(isOfNewerVersion(fragment));

  const history = signal(noHistory);
  const draft = signal<Draft | undefined>(undefined);

  const change = (next: PageState, doing: Doing) => {
    batch(() => {
      history.value = recorded(history.peek(), state.peek(), next, doing, Date.now());
      state.value = next;
    });
  };
  const move = (to: typeof undone): (keyof Content)[] | undefined => {
    const before = state.peek();
    const moved = to(history.peek(), before.view);
    if (moved === undefined) return undefined;
    batch(() => {
      history.value = moved.history;
      state.value = { ...before, ...moved.change };
    });
    return changedParts(before, moved.change);
  };
  const can = (to: (...given: Parameters<typeof undone>) => Move | undefined) =>
    computed(() => to(history.value, state.value.view) !== undefined);

  // As text, so that what asks nothing of the core, such as the look of the picture, runs nothing.
  const asked = computed(() => JSON.stringify(requestOf(state.value)));
  const outcome = computed(() => {
    asked.value;
    return answer(state.peek(), engine.value);
  });

  const answerBeside = (asks: Asks) => {
    const asked = computed(() => JSON.stringify(asks(state.value)));
    return computed(() => {
      asked.value;
      const request = asks(state.peek());
      return request && engine.value.isWhole ? engine.value.analyze(request) : undefined;
    });
  };

  /** Whether the core that is there cannot read a text, and the whole one may. */
  const mayBeRead = computed(() => outcome.value?.status === "problems" && !engine.value.isWhole);
  const wholeCore = signal<"awaited" | "missing">("awaited");
  const isReading = computed(() => mayBeRead.value && wholeCore.value === "awaited");

  const problems = computed<Problem[]>(() =>
    outcome.value?.status === "problems" && !isReading.value ? outcome.value.problems : [],
  );

  const failure = computed(() =>
    outcome.value?.status === "failure" ? outcome.value.message : undefined,
  );

  const besides = new Map<Asks, ReadonlySignal<Answer>>();

  // The last good result of each view stays while the text has a problem; before the first one it
  // is the opening example, once it is known that the text has one.
  const lastOf = <Status extends Good["status"]>(status: Status) =>
    lastGood(
      () => outcome.value,
      () => (isReading.value ? undefined : answer({ ...opening, view: status }, engine.value)),
      (outcome): outcome is Good & { status: Status } => outcome?.status === status,
    );

  return {
    state,
    get engine() {
      return engine.value;
    },
    /** Answers with another core from now on. */
    useEngine: (other: Engine) => {
      if (other === engine.peek()) return;
      batch(() => {
        engine.value = other;
        state.value = withKnownLibraries(state.peek(), isLibrary.peek());
      });
    },
    /** Whether the opened link is of a newer quatlas. */
    isLinkNewer,
    read: lastOf("read"),
    compose: lastOf("compose"),
    translate: lastOf("translate"),
    identify: lastOf("identify"),
    motion: lastOf("motion"),
    frames: lastOf("frames"),
    /** What is asked beside a view, from when the core that answers it is there; one answer for each question. */
    beside: (asks: Asks): ReadonlySignal<Answer> => {
      const known = besides.get(asks) ?? answerBeside(asks);
      besides.set(asks, known);
      return known;
    },
    failure,
    mayBeRead,
    /** What has become of the whole core where it is needed. */
    wholeCore,
    /** Whether it is not known yet what a text is. */
    isReading,
    problems,
    problemOf: (field: Field) => problems.value.find((problem) => problem.field === field),
    /** The numbers of the result that are being edited. */
    draft,
    /** The state as the address holds it. */
    addressed: computed(() => addressed(state.value, outcome.value)),
    /** Changes the state; what is done as the same follows as one step of the history. */
    set: (parts: Partial<PageState>, doing: Doing = {}) => {
      endAnnouncement();
      change({ ...state.peek(), ...parts }, doing);
    },
    open: (fragment: string) => {
      change(stateOf(fragment), {});
      isLinkNewer.value = isOfNewerVersion(fragment);
    },
    /** The address of the state with some changes. */
    linkTo: (parts: Partial<PageState>) => `#${toFragment({ ...state.value, ...parts })}`,
    /** Ends a step: what follows is undone by itself. */
    step: () => {
      history.value = closed(history.peek());
    },
    /** Takes the last step of the view back, and returns what it changed; nothing where there is none. */
    undo: () => move(undone),
    /** Does again what was taken back last, and returns what it changed; nothing where there is none. */
    redo: () => move(redone),
    canUndo: can(undone),
    canRedo: can(redone),
  };
}

/** Which ids are those of libraries; without the table any may be. */
function knownBy({ libraries }: Engine): (id: string) => boolean {
  if (libraries.length === 0) return () => true;
  const known = new Set(libraries.map(({ id }) => id));
  return (id) => known.has(id);
}

/** What the core answers to a state; nothing where its view asks nothing, or more than this core knows. */
function answer(state: PageState, engine: Engine): Answer {
  const request = requestOf(state);
  const isAnswered = engine.isWhole || smallViews.includes(state.view);
  return request && isAnswered ? engine.analyze(request) : undefined;
}

/** What a view asks the core of a state; nothing where it asks nothing. */
export type Asks = (state: PageState) => Request | undefined;

/** What the views ask that are loaded later, from when their file is there. */
export const asksOf = signal<Partial<Record<View, Asks>>>({});

/** What a state asks the core; nothing where its view asks nothing. */
export function requestOf(state: PageState): Request | undefined {
  const { view, quaternion, p, q, vector, matrix, euler } = state;
  const convention = declaredConvention(state);
  if (view === "read") return { view, quaternion, vector, convention, matrix, euler };
  if (view === "compose") return { view, p, q, vector, convention, matrix };
  return asksOf.value[view]?.(state);
}

type Good = Extract<
  Outcome,
  { status: "read" | "compose" | "translate" | "identify" | "frames" | "motion" }
>;

/** The newest outcome of one kind, and whether it belongs to the texts as they are now. */
function lastGood<Kind extends Good>(
  now: () => Answer,
  first: () => Answer,
  isGood: (outcome: Answer) => outcome is Kind,
) {
  let last: Kind | undefined;
  let freshness: Freshness = "old";
  return computed<Shown<Kind> | undefined>(() => {
    const outcome = now();
    if (isGood(outcome)) {
      last = outcome;
      freshness = "old";
      return { report: outcome, freshness: "current" };
    }
    if (last === undefined) {
      const example = first();
      if (isGood(example)) last = example;
      freshness = "opening";
    }
    return last && { report: last, freshness };
  });
}
