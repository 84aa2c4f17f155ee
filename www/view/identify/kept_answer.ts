// Which answer is shown: the newest, or the last good one where an observation has a problem.
import { computed, type ReadonlySignal } from "@preact/signals";
import type { BehaviourAxis, Contradiction, IdentifyReport, Probe } from "../../engine.ts";
import { settledValue } from "../../model/behaviour.ts";
import type { Store } from "../../state/store.ts";

/** How an answer relates to the observations: theirs, that of earlier ones, or that of the others. */
export type Age = "current" | "old" | "of-others";

export interface Answer {
  /** What became of each observation as it is now. */
  report: IdentifyReport;
  /** What is said of the library. */
  shown: IdentifyReport;
  age: Age;
  /** The places of the observations that do not count. */
  uncounted: readonly number[];
}

/**
 * An observation that cannot be read takes nothing away: what was known before stays, marked as old,
 * until the text is mended. So it is with observations that contradict each other.
 */
export function keptAnswer(store: Store): ReadonlySignal<Answer | undefined> {
  let last: { report: IdentifyReport; observations: readonly Probe[] } | undefined;
  return computed(() => {
    const report = store.identify.value?.report;
    if (report === undefined) return undefined;
    const { observations } = store.state.value;
    const uncounted = observations.flatMap((_, at) => (isUncounted(report, at) ? [at] : []));
    const before = last && differ(last.observations, observations) <= 1 ? last.report : undefined;
    if (report.contradiction !== undefined) {
      const disagreeing = report.contradiction.observations;
      const others = () => answerWithout(store, disagreeing) ?? report;
      const age = before ? "old" : "of-others";
      return { report, shown: before ?? others(), age, uncounted };
    }
    if (uncounted.length > 0 && before && before.possible < report.possible) {
      return { report, shown: before, age: "old", uncounted };
    }
    if (uncounted.length === 0 || before === undefined) last = { report, observations };
    return { report, shown: report, age: "current", uncounted };
  });
}

function isUncounted(report: IdentifyReport, at: number): boolean {
  const status = report.observations[at]?.status;
  return status === "problem" || status === "unexplained";
}

/** At how many places two lists of observations differ. */
function differ(some: readonly Probe[], others: readonly Probe[]): number {
  const longer = some.length > others.length ? some : others;
  return longer.filter((_, at) => JSON.stringify(some[at]) !== JSON.stringify(others[at])).length;
}

function ask(store: Store, observations: Probe[]): IdentifyReport | undefined {
  const { libraryName, language, unavailable } = store.state.value;
  const answer = store.engine.analyze({
    view: "identify",
    observations,
    name: libraryName,
    language,
    unavailable: [...unavailable],
  });
  return answer.status === "identify" ? answer : undefined;
}

function answerWithout(store: Store, left: readonly number[]): IdentifyReport | undefined {
  return ask(
    store,
    store.state.value.observations.filter((_, at) => !left.includes(at)),
  );
}

/** One side of a contradiction. */
export interface Claim {
  /** The place of the observation. */
  at: number;
  /** The values that it says of what is disputed. */
  says: { choice: BehaviourAxis; value: string }[];
  /** How many behaviours agree with all the others; 0 where they contradict each other too. */
  leavesWithout: number;
}

/** What each of the observations that contradict each other says: alone, or with those that do not. */
export function claims(store: Store, { observations, about }: Contradiction): Claim[] {
  return observations.map((at) => {
    const probe = store.state.value.observations[at];
    const alone = probe && ask(store, [probe]);
    const withOthers = answerWithout(
      store,
      observations.filter((other) => other !== at),
    );
    const says = about.flatMap((choice) => {
      const value =
        (alone && settledValue(alone.remaining, choice)) ??
        (withOthers && settledValue(withOthers.remaining, choice));
      return value === undefined ? [] : [{ choice, value }];
    });
    return { at, says, leavesWithout: answerWithout(store, [at])?.possible ?? 0 };
  });
}
