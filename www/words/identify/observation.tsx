// The words of one observation: what its parts are called, and what it tells.
import type { BehaviourAxis, Problem } from "../../engine.ts";
import { numbered } from "../phrases.ts";
import { aboutOf, allBehaviours, unexplainedAdvice } from "./choices.ts";

/** What a field or a button belongs to. */
export const of = (at: number) => `observation ${at + 1}`;

export const question = (at: number) => `Question ${at + 1}: `;
export const observation = (at: number) => `Observation ${at + 1}: `;
export const contradicts = (others: readonly number[]) => `contradicts ${numbered(others)}`;
export const code = (at: number) => `the code of observation ${at + 1}`;
export const layout = "nine numbers";
export const empty = "Not answered yet.";

export const problemOf = ({ message, expected, hint }: Problem) => (
  <>
    <span class="problem-message">{message}.</span> <span class="problem-key">Expected:</span>{" "}
    {expected}. <span class="problem-key">Try:</span> {hint}.
  </>
);

/** How far the numbers are off, in per cent; nothing where they have no direction. */
export const unexplained = (off: string | undefined) => (
  <>
    <span class="problem-message">
      No behaviour prints this
      {off === undefined ? ": it has no direction." : `; the nearest is off by ${off} of its size.`}
    </span>{" "}
    <span class="problem-key">Look for</span> {unexplainedAdvice.join("; ")}.
  </>
);

export const told = (settled: readonly BehaviourAxis[], possible: number) => (
  <>
    {settled.length === 0 ? (
      "Settles no choice by itself"
    ) : (
      <>
        Settles <strong>{aboutOf(settled)}</strong>
      </>
    )}
    ; {possible} of {allBehaviours} behaviours print this.
  </>
);

export const rounded = (off: string) => ` Rounded: off by ${off}.`;
