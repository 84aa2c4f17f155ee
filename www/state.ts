// The one mutable value of the page, and what follows from it.
import { computed, signal } from "@preact/signals";
import { fromFragment, opening, type PageState } from "./address.ts";
import type {
  ComposeReport,
  Convention,
  Engine,
  Field,
  Outcome,
  Problem,
  ReadReport,
  Request,
} from "./engine.ts";

/** How a result relates to the texts above it: theirs, that of earlier texts, or the opening one. */
export type Freshness = "current" | "old" | "opening";

export interface Shown<Report> {
  report: Report;
  freshness: Freshness;
}

export type Store = ReturnType<typeof createStore>;

export function createStore(engine: Engine, fragment: string) {
  const state = signal<PageState>(fromFragment(fragment));

  const outcome = computed(() => engine.analyze(requestOf(state.value, engine)));

  const problems = computed<Problem[]>(() =>
    outcome.value.status === "problems" ? outcome.value.problems : [],
  );

  const failure = computed(() =>
    outcome.value.status === "failure" ? outcome.value.message : undefined,
  );

  // The last good result of each view stays while the text has a problem; before the first one it
  // is the opening example.
  const openingOutcome = (view: PageState["view"]) =>
    engine.analyze(requestOf({ ...opening, view }, engine));
  const read = lastGood(
    () => outcome.value,
    () => openingOutcome("read"),
    isRead,
  );
  const compose = lastGood(
    () => outcome.value,
    () => openingOutcome("compose"),
    isCompose,
  );

  return {
    state,
    engine,
    read,
    compose,
    failure,
    problems,
    problemOf: (field: Field) => problems.value.find((problem) => problem.field === field),
    set: (change: Partial<PageState>) => {
      state.value = { ...state.value, ...change };
    },
    open: (fragment: string) => {
      state.value = fromFragment(fragment);
    },
  };
}

function requestOf(state: PageState, engine: Engine): Request {
  const { view, quaternion, p, q, vector, matrix, euler } = state;
  const convention = declaredConvention(state, engine);
  return view === "read"
    ? { view, quaternion, vector, convention, matrix, euler }
    : { view, p, q, vector, convention, matrix };
}

/** What four typed numbers are declared to mean. */
export function declaredConvention(state: PageState, engine: Engine): Convention {
  return { ...engine[state.preset], ...state.axes };
}

type Answer = ReturnType<Engine["analyze"]>;
type ReadOutcome = ReadReport & { status: "read" };
type ComposeOutcome = ComposeReport & { status: "compose" };

const isRead = (outcome: Answer): outcome is ReadOutcome & Outcome => outcome.status === "read";
const isCompose = (outcome: Answer): outcome is ComposeOutcome & Outcome =>
  outcome.status === "compose";

/** The newest outcome of one kind, and whether it belongs to the texts as they are now. */
function lastGood<Good extends Answer>(
  now: () => Answer,
  first: () => Answer,
  isGood: (outcome: Answer) => outcome is Good,
) {
  let last: Good | undefined;
  let freshness: Freshness = "old";
  return computed<Shown<Good> | undefined>(() => {
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
