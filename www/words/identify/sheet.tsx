// The words of the sheet on which observations are entered.
import { listed } from "../phrases.ts";

export const title = "What it printed";
export const example = "an example";

export const lead = (
  <>
    Put the names of your library into these lines, run them, and enter what they print; Enter goes
    on. Four numbers are in the library's own order; with names, <code>w: 1, x: 0, …</code>, the
    order does not matter. Rounded numbers, single precision and −q for q are fine.
  </>
);

export const settled = "The library is settled; this tells how it is used.";

export const remove = (at: number) => (
  <>
    Remove<span class="visually-hidden"> observation {at + 1}</span>
  </>
);

export const cannotRun = "I cannot run this";

/** Why nothing is asked. */
export const questionAfterContradiction = "The next question comes when nothing is contradicted.";
export const questionAfter = (at: number) =>
  `The next question comes when observation ${at + 1} is answered.`;
export const full = (most: number) => `A sheet holds ${most} observations.`;
export const allSettled = "Nothing more to ask: all that numbers can tell is settled.";
export const noneToRun = "None of the probes that you can run tells more.";
export const noneTellsMore = "No other probe tells more.";

export const notAsked = (probes: readonly string[]) =>
  `Not asked, because you cannot run it: ${listed(probes)}.`;

export const askAgain = "Ask again";
export const add = "Or enter something else that it printed";
export const onceMore = " once more";
