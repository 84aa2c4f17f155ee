// What is chosen in Motion beside the texts, as one text of the address: words and numbers, the usual ones left out.
import type { IncrementSign, MistakeKind, PathReport, RateAxes } from "../engine.ts";
import type { PageState } from "./page_state.ts";

export interface Choices {
  rateAxes: RateAxes;
  incrementSign: IncrementSign;
  steps: number;
  /** The mistake that is drawn beside the right motion. */
  drawn: MistakeKind | undefined;
  /** The place of the moment that is shown. */
  moment: number;
}

export const drawable = ["other-side", "other-sign", "half-forgotten"] as const;
export const mostSteps = 240;
const usual = { steps: 40, drawn: drawable[0] };
const nothingDrawn = "right-only";

export function choicesOf({ motion }: PageState): Choices {
  const told = motion.split(" ");
  const steps = Math.min(numberAfter("n", told) ?? usual.steps, mostSteps) || 1;
  return {
    rateAxes: told.includes("world") ? "world" : "body",
    incrementSign: told.includes("formal") ? "formal" : "physical",
    steps,
    drawn: told.includes(nothingDrawn)
      ? undefined
      : (drawable.find((kind) => told.includes(kind)) ?? usual.drawn),
    moment: Math.min(numberAfter("at", told) ?? steps, steps),
  };
}

export function textOf({ rateAxes, incrementSign, steps, drawn, moment }: Choices): string {
  return [
    rateAxes === "world" && "world",
    incrementSign === "formal" && "formal",
    steps !== usual.steps && `n${steps}`,
    drawn !== usual.drawn && (drawn ?? nothingDrawn),
    moment < steps && `at${moment}`,
  ]
    .filter((word) => word)
    .join(" ");
}

function numberAfter(letters: string, told: readonly string[]): number | undefined {
  const digits = told
    .map((word) => word.match(/^([a-z]+)(\d{1,3})$/))
    .find((found) => found?.[1] === letters);
  return digits ? Number(digits[2]) : undefined;
}

/** The way of the body with a mistake. */
export function wayWith(kind: MistakeKind, { mistakes, ways }: PathReport) {
  return ways[1 + mistakes.findIndex((mistake) => mistake.kind === kind)];
}
