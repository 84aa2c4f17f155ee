// The core that the package asks. How its wasm comes is told by the entry, and it starts when it is first asked.
import {
  analyze,
  type Outcome,
  type Request,
  startAnew,
  takePanicMessage,
} from "../../pkg/quatlas.js";
import { answering } from "./answering.ts";

const answerOfCore = answering({ analyze, startAnew, takePanicMessage });

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
  if (start !== undefined) {
    const wasBroken = isBroken;
    isBroken = true;
    start();
    // What was left half made, where the stack was full, is not to be trusted.
    if (wasBroken) startAnew();
    isBroken = false;
    start = undefined;
  }
  return answerOfCore(request, view);
}
