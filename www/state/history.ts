// What undo takes back and redo does again; pure.
//
// A step holds the parts of the state that changed, before and after, and belongs to the view that it
// was made in: undo never changes what is out of sight, and the views themselves stay with the
// history of the browser.
import type { PageState, View } from "../model/page_state.ts";

/** Parts of the state that say how to look at it: undo leaves them alone. */
const looks = ["view", "digits", "unit", "picture", "open"] as const satisfies (keyof PageState)[];
type Look = (typeof looks)[number];
export type Content = Omit<PageState, Look>;
type Part = keyof Content;

/** How a change becomes a step. */
export interface Doing {
  /** Changes that follow each other as the same doing are one step. */
  as?: string;
  /** For how many milliseconds the doing may rest and still be the same; one second if left out. */
  restMs?: number;
}

interface Step extends Doing {
  view: View;
  before: Partial<Content>;
  after: Partial<Content>;
  /** When it was last added to. */
  at: number;
}

export interface History {
  done: readonly Step[];
  /** What was undone, the last first. */
  undone: readonly Step[];
  /** Whether the newest step may be added to. */
  isOpen: boolean;
}

/** What a step back or forward does. */
export interface Move {
  history: History;
  change: Partial<Content>;
}

export const noHistory: History = { done: [], undone: [], isOpen: false };

const mostSteps = 200;
const usualRestMs = 1000;

/** The history after a change; it stays the same where nothing changed that can be undone. */
export function recorded(
  history: History,
  before: PageState,
  after: PageState,
  doing: Doing,
  now: number,
): History {
  const parts = changedParts(before, after);
  if (parts.length === 0) return history;
  const as = doing.as ?? usualDoing(parts);
  const step: Step = {
    ...doing,
    ...(as === undefined ? {} : { as }),
    view: after.view,
    before: picked(before, parts),
    after: picked(after, parts),
    at: now,
  };
  const last = history.done.at(-1);
  if (last === undefined || !history.isOpen || !isSame(last, step)) {
    return { done: [...history.done, step].slice(-mostSteps), undone: [], isOpen: true };
  }
  const joined = join(last, step);
  const earlier = history.done.slice(0, -1);
  // What was changed and changed back is no step.
  return changedParts(joined.before, joined.after).length === 0
    ? { done: earlier, undone: [], isOpen: false }
    : { done: [...earlier, joined], undone: [], isOpen: true };
}

/** The newest step is complete: what follows is another one. */
export function closed(history: History): History {
  return history.isOpen ? { ...history, isOpen: false } : history;
}

/** One step back in a view; nothing where there is none. */
export function undone(history: History, view: View): Move | undefined {
  const step = history.done.findLast((step) => step.view === view);
  if (step === undefined) return undefined;
  return {
    history: {
      done: history.done.filter((other) => other !== step),
      undone: [step, ...history.undone],
      isOpen: false,
    },
    change: step.before,
  };
}

/** The step that was undone last in a view, again. */
export function redone(history: History, view: View): Move | undefined {
  const step = history.undone.find((step) => step.view === view);
  if (step === undefined) return undefined;
  return {
    history: {
      done: [...history.done, step],
      undone: history.undone.filter((other) => other !== step),
      isOpen: false,
    },
    change: step.after,
  };
}

function isSame(last: Step, step: Step): boolean {
  const restMs = last.restMs ?? usualRestMs;
  return (
    step.as !== undefined &&
    step.as === last.as &&
    step.view === last.view &&
    step.at - last.at <= restMs
  );
}

function join(last: Step, step: Step): Step {
  return {
    ...step,
    before: { ...step.before, ...last.before },
    after: { ...last.after, ...step.after },
  };
}

/** Typing is one doing as long as it is in the same texts; a choice is a step of its own. */
function usualDoing(parts: readonly Part[]): string | undefined {
  return parts.every((part) => typed.has(part)) ? `typing ${parts.join(" ")}` : undefined;
}

const typed: ReadonlySet<Part> = new Set<Part>([
  ...(["quaternion", "p", "q", "vector", "translated", "worldAxes", "bodyAxes"] as const),
  ...(["observations", "libraryName", "numbers", "beside", "find", "part", "axis"] as const),
]);

/** What differs, in the order of the state. */
export function changedParts(before: Partial<PageState>, after: Partial<PageState>): Part[] {
  const parts = Object.keys(after) as (keyof PageState)[];
  return parts.filter((part): part is Part => !isLook(part) && !isEqual(before[part], after[part]));
}

function isLook(part: keyof PageState): part is Look {
  return looks.some((look) => look === part);
}

function isEqual(one: unknown, other: unknown): boolean {
  return one === other || JSON.stringify(one) === JSON.stringify(other);
}

function picked(state: PageState, parts: readonly Part[]): Partial<Content> {
  return Object.fromEntries(parts.map((part) => [part, state[part]]));
}
