// What is said of observations that contradict each other.
import type { BehaviourAxis, Contradiction } from "../../engine.ts";
import { numbered } from "../phrases.ts";
import { aboutOf, allBehaviours, checkSource, checks } from "./choices.ts";

export const message = ({ observations, about }: Contradiction) =>
  `Observations ${numbered(observations)} cannot ${observations.length === 2 ? "both" : "all"} be true${
    about.length > 0 ? `: they disagree about ${aboutOf(about)}` : ""
  }.`;

export const claims = "What each of them says";
export const nothing = "nothing by itself";

export const without = (left: number) =>
  left === 0
    ? "without it the others still disagree"
    : `without it ${left} of ${allBehaviours} left`;

export const check = (about: readonly BehaviourAxis[]) => (
  <>
    <span class="problem-key">Check</span>{" "}
    {[...about.map((choice) => checks[choice]), checkSource].join("; ")}.
  </>
);
