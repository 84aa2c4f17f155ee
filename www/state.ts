// The one mutable value of the page, and what follows from it.
import { batch, computed, signal } from "@preact/signals";
import { fromFragment, opening, type PageState, withKnownLibraries } from "./address.ts";
import type { Convention, Engine, Field, Outcome, Problem, Request } from "./engine.ts";

/** How a result relates to the texts above it: theirs, that of earlier texts, or the opening one. */
export type Freshness = "current" | "old" | "opening";

export interface Shown<Report> {
  report: Report;
  freshness: Freshness;
}

export type Store = ReturnType<typeof createStore>;

export function createStore(first: Engine, fragment: string) {
  const engine = signal(first);
  const isLibrary = computed(() => knownBy(engine.value));
  const stateOf = (fragment: string) => fromFragment(fragment, isLibrary.peek());
  const state = signal<PageState>(stateOf(fragment));

  const outcome = computed(() => answer(state.value, engine.value));

  const problems = computed<Problem[]>(() =>
    outcome.value?.status === "problems" ? outcome.value.problems : [],
  );

  const failure = computed(() =>
    outcome.value?.status === "failure" ? outcome.value.message : undefined,
  );

  // The last good result of each view stays while the text has a problem; before the first one it
  // is the opening example.
  const lastOf = <Status extends Good["status"]>(status: Status) =>
    lastGood(
      () => outcome.value,
      () => answer({ ...opening, view: status }, engine.value),
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
    read: lastOf("read"),
    compose: lastOf("compose"),
    translate: lastOf("translate"),
    identify: lastOf("identify"),
    failure,
    problems,
    problemOf: (field: Field) => problems.value.find((problem) => problem.field === field),
    set: (change: Partial<PageState>) => {
      state.value = { ...state.value, ...change };
    },
    open: (fragment: string) => {
      state.value = stateOf(fragment);
    },
  };
}

/** Which ids are those of libraries; without the table any may be. */
function knownBy({ libraries }: Engine): (id: string) => boolean {
  if (libraries.length === 0) return () => true;
  const known = new Set(libraries.map(({ id }) => id));
  return (id) => known.has(id);
}

type Answer = ReturnType<Engine["analyze"]> | undefined;

/** What the core answers to a state; nothing where its view asks nothing, or more than this core knows. */
function answer(state: PageState, engine: Engine): Answer {
  const request = requestOf(state, engine);
  return request && engine.views.includes(request.view) ? engine.analyze(request) : undefined;
}

function requestOf(state: PageState, engine: Engine): Request | undefined {
  const { view, quaternion, p, q, vector, matrix, euler } = state;
  const convention = declaredConvention(state, engine);
  switch (view) {
    case "read":
      return { view, quaternion, vector, convention, matrix, euler };
    case "compose":
      return { view, p, q, vector, convention, matrix };
    case "translate": {
      const { translated, from, to, worldAxes, bodyAxes } = state;
      return { view, quaternion: translated, from, to, worldAxes, bodyAxes };
    }
    case "identify": {
      const { observations, libraryName, language, unavailable } = state;
      return {
        view,
        observations: [...observations],
        name: libraryName,
        language,
        unavailable: [...unavailable],
      };
    }
    case "libraries":
      return undefined;
  }
}

/** What four typed numbers are declared to mean. */
export function declaredConvention(state: PageState, engine: Engine): Convention {
  return { ...engine[state.preset], ...state.axes };
}

type Good = Extract<Outcome, { status: "read" | "compose" | "translate" | "identify" }>;

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
