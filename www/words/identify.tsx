// The words of the Identify view: the sheet, the observations, the answer and what follows from it.
import type { BehaviourAxis, Contradiction, Problem } from "../engine.ts";
import { notEstablished } from "./library_behaviour.ts";
import { checkSource, checks, choiceWords, unexplainedAdvice } from "./observations.ts";
import { listed, numbered } from "./phrases.ts";

/** As what choices are settled or disputed. */
const aboutOf = (choices: readonly BehaviourAxis[]) =>
  listed(choices.map((choice) => choiceWords[choice].about));

export const identifyWords = {
  input: "Input",
  none: "No answer yet.",
  lead: "Which convention does this library use? Three short lines of code are usually enough to tell.",
  start: "Start with an empty sheet",
  library: "Library",
  code: "Code in",
  examples: "Examples",
  /** What libraries print, one example of each surprise. */
  exampleNames: {
    "not-jpl": "ij = −k and yet not JPL",
    stored: "Hamilton, stored x y z w",
    rounded: "Rounded, and −q",
    contradiction: "A contradiction",
  },
  seeAnswer: "See the answer",
  /** Where the library has no name yet. */
  unnamed: "The library",
} as const;

export const sheetWords = {
  title: "What it printed",
  example: "an example",
  lead: (
    <>
      Put the names of your library into these lines, run them, and enter what they print; Enter
      goes on. Four numbers stand as the library takes and prints them; with names,{" "}
      <code>w: 1, x: 0, …</code>, their order is no question. Rounded numbers, single precision and
      −q for q are fine.
    </>
  ),
  settled: "The library is settled; this tells how it is used.",
  remove: (at: number) => (
    <>
      Remove<span class="visually-hidden"> observation {at + 1}</span>
    </>
  ),
  cannotRun: "I cannot run this",
  /** Why nothing is asked. */
  noQuestion: {
    contradicted: "The next question comes when nothing is contradicted.",
    open: (at: number) => `The next question comes when observation ${at + 1} is answered.`,
    full: (most: number) => `A sheet holds ${most} observations.`,
    settled: "Nothing more to ask: all that numbers can tell is settled.",
    unavailable: "None of the probes that you can run tells more.",
    exhausted: "No other probe tells more.",
  },
  notAsked: (probes: readonly string[]) =>
    `Not asked, because you cannot run it: ${listed(probes)}.`,
  askAgain: "Ask again",
  add: "Or enter something else that it printed",
  onceMore: " once more",
} as const;

export const observationWords = {
  /** What a field or a button belongs to. */
  of: (at: number) => `observation ${at + 1}`,
  question: (at: number) => `Question ${at + 1}: `,
  observation: (at: number) => `Observation ${at + 1}: `,
  contradicts: (others: readonly number[]) => `contradicts ${numbered(others)}`,
  code: (at: number) => `the code of observation ${at + 1}`,
  layout: "nine numbers",
  empty: "Not answered yet.",
  problem: ({ message, expected, hint }: Problem) => (
    <>
      <span class="problem-message">{message}.</span> <span class="problem-key">Expected</span>{" "}
      {expected}. <span class="problem-key">Try</span> {hint}.
    </>
  ),
  /** How far the numbers are off, in per cent; nothing where they have no direction. */
  unexplained: (off: string | undefined) => (
    <>
      <span class="problem-message">
        No behaviour prints this
        {off === undefined
          ? ": it has no direction."
          : `; the nearest is off by ${off} of its size.`}
      </span>{" "}
      <span class="problem-key">Look for</span> {unexplainedAdvice.join("; ")}.
    </>
  ),
  told: (settled: readonly BehaviourAxis[], possible: number) => (
    <>
      {settled.length === 0 ? (
        "Settles no choice by itself"
      ) : (
        <>
          Settles <strong>{aboutOf(settled)}</strong>
        </>
      )}
      ; {possible} of 128 behaviours print this.
    </>
  ),
  rounded: (off: string) => ` Rounded: off by ${off}.`,
} as const;

export const answerWords = {
  left: (possible: number) =>
    possible === 1 ? "1 of 128 behaviours is left" : `${possible} of 128 behaviours are left`,
  copied: "the sentence for an issue",
  fromBeforeContradiction: "What stands below is the last result, from before the contradiction.",
  fromBeforeChange: (places: readonly number[]) =>
    `What stands below is the last result, from before the change of ${theObservations(places)}.`,
  ofOthers: "What stands below is what the other observations say.",
  uncounted: (places: readonly number[]) =>
    `Not counted: ${theObservations(places)}, which ${places.length === 1 ? "tells" : "tell"} nothing yet.`,
  choices: (
    <>
      <span class="visually-hidden">The seven choices and the values that are left. </span>
      <var>R</var>(<var>q</var>) is Hamilton's matrix, and <var>C</var>(<var>q</var>) its transpose.
    </>
  ),
  ofLibrary: "What it does",
  ofUse: "How it is used",
  settled: (count: number, all: number) => `${count} of ${all} settled`,
  /** Said before a value. */
  standing: { settled: "settled: ", open: "possible: ", out: "ruled out: " },
} as const;

function theObservations(places: readonly number[]): string {
  return `observation${places.length === 1 ? "" : "s"} ${numbered(places)}`;
}

export const contradictionWords = {
  message: ({ observations, about }: Contradiction) =>
    `Observations ${numbered(observations)} cannot ${observations.length === 2 ? "both" : "all"} be true${
      about.length > 0 ? `: they disagree about ${aboutOf(about)}` : ""
    }.`,
  claims: "What each of them says",
  withOthers: "only with the others",
  without: (left: number) =>
    left === 0 ? "without it the others still disagree" : `without it ${left} of 128 left`,
  check: (about: readonly BehaviourAxis[]) => (
    <>
      <span class="problem-key">Check</span>{" "}
      {[...about.map((choice) => checks[choice]), checkSource].join("; ")}.
    </>
  ),
} as const;

export const matchWords = {
  title: (count: number, all: number) => `Records that match: ${count} of ${all}`,
  none: "No record of the table behaves like this. It may be right all the same.",
  agree: "Establish all five choices, and agree",
  leaveOpen: "Leave one or two choices open, and agree",
  sayLittle: (count: number) => `${count} more establish too little to disagree`,
  more: (count: number) => `${count} more`,
  unestablished: (choices: readonly BehaviourAxis[]) => `${notEstablished}: ${aboutOf(choices)}`,
} as const;

export const meaningWords = {
  relatives: "Between Hamilton and JPL",
  product: "product",
  rotates: "rotates a column by",
  actsFirst: "acts first in a * b",
  operand: { left: "a, the left", right: "b, the right" },
  open: "open",
  familyOpen: "Open until the product and the rotation are settled.",
  first: (operand: string) => (
    <>
      In <code>a * b</code> <strong>{operand}</strong> acts first on a vector.
    </>
  ),
  firstOpen: "Which operand acts first follows from the product and the rotation: still open.",
  takes: (coordinates: string) => (
    <>
      For the attitude of a body the call that rotates takes <strong>{coordinates}</strong>.
    </>
  ),
  takesOpen:
    "Which coordinates to which it takes depends on how an attitude is written: a body turned by a quarter tells.",
  columns: (
    <>
      Its matrix multiplies <strong>column vectors</strong> as the call that rotates does.
    </>
  ),
  rows: (
    <>
      Its matrix is the transpose of what rotates: it is for <strong>row vectors</strong>, x&nbsp;M,
      or it is the inverse.
    </>
  ),
  unsettled: "What no numbers tell",
  labels:
    "A function and a direction reversed together leave every number as it is. Which of the two labels is meant, only the documentation says.",
  label: (name: string, direction: string, effect: string) => `${name}, ${direction} (${effect})`,
  either: (labels: readonly string[]) => listed(labels, "or"),
} as const;

/** What a screen reader hears when the result changes. */
export const spokenWords = {
  unexplained: (at: number) => `Observation ${at + 1}: no behaviour prints this.`,
  problem: (at: number, { message, expected, hint }: Problem) =>
    `Problem in observation ${at + 1}: ${message}. Expected ${expected}. Try ${hint}.`,
  contradiction: ({ observations, about }: Contradiction) =>
    `Observations ${numbered(observations)} contradict each other.${
      about.length > 0 ? ` They disagree about ${aboutOf(about)}.` : ""
    }`,
  answer: (possible: number, sentence: string) => `${answerWords.left(possible)}. ${sentence}`,
} as const;
