// How a core is asked: what it refuses is thrown, and after a trap it is made anew.
import type { Outcome, Request } from "../../pkg/quatlas.js";

/** What a core exports for this; see `src/wasm/mod.rs`. */
export interface Core {
  analyze: (
    request: unknown,
    view?: Request["view"],
  ) => Outcome | { status: "refused"; error: unknown };
  startAnew: () => void;
  takePanicMessage: () => string | undefined;
}

/** The core stopped before it had an answer: a mistake in quatlas, never in a request. */
export class CoreStopped extends Error {
  /** What is known of it. */
  readonly reason: string;

  constructor(reason: string, cause: unknown) {
    super(`this is a mistake in quatlas, please report it: ${reason}`, { cause });
    this.reason = reason;
  }
}

/**
 * The value of a call of a core, which is made anew before the next one after a trap. A call throws only
 * where it trapped, and that as a `CoreStopped`.
 */
export function calling(core: Core): <Value>(call: () => Value) => Value {
  /** Calls under way: a getter of a request may ask something itself. */
  let depth = 0;
  let stopped: CoreStopped | undefined;

  return (call) => {
    if (stopped !== undefined) {
      // Made anew under a call that is still under way, that one would go on with foreign memory.
      if (depth > 0) throw stopped;
      core.startAnew();
      stopped = undefined;
    }
    depth += 1;
    try {
      return call();
    } catch (error) {
      // Here the stack may be full: what needs more of it waits for the next call.
      stopped = new CoreStopped(panicMessage(core) ?? String(error), error);
      throw stopped;
    } finally {
      depth -= 1;
    }
  };
}

/**
 * The answer of a core to a request. It throws a `TypeError`, or what the request itself threw, where the
 * core refuses the request, and a `CoreStopped` after a trap.
 */
export function answering(
  core: Core,
  call = calling(core),
): (request: unknown, view?: Request["view"]) => Outcome {
  return (request, view) => {
    const answer = call(() => core.analyze(request, view));
    if (answer.status === "refused") throw answer.error;
    return answer;
  };
}

/** What a panic said; the core that panicked may not be able to tell. */
function panicMessage(core: Core): string | undefined {
  try {
    return core.takePanicMessage();
  } catch {
    return undefined;
  }
}
