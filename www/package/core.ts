// The core that the package asks. How its wasm comes is told by the entry, and it starts when it is first asked.
import {
  analyze,
  describeLibrary,
  type LibraryDescription,
  type Outcome,
  type Request,
  startAnew,
  takePanicMessage,
} from "../../pkg/quatlas.js";
import { answering, calling } from "./answering.ts";

const core = { analyze, startAnew, takePanicMessage };
const call = calling(core);
const answerOfCore = answering(core, call);

/** Makes the core ready, or throws what keeps it from that. */
let start: (() => void) | undefined;
/** Whether a start was begun and did not end. */
let isBroken = false;

/** How the core is to be started, before its first answer. */
export function startCoreBy(starting: () => void): void {
  start = starting;
  isBroken = false;
}

/** The answer of the core to a request; see `answering`. */
export function answer(request: unknown, view?: Request["view"]): Outcome {
  begin();
  return answerOfCore(request, view);
}

/** What a library does by itself; nothing for an id that no library has. */
export function libraryOf(id: string): LibraryDescription | undefined {
  begin();
  return call(() => describeLibrary(id));
}

function begin(): void {
  if (start === undefined) return;
  const wasBroken = isBroken;
  isBroken = true;
  start();
  // What was left half made, where the stack was full, is not to be trusted.
  if (wasBroken) startAnew();
  isBroken = false;
  start = undefined;
}
