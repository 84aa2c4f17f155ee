// The one door to the core: the only file of the page that imports the wasm.
import type { Library, Outcome, Request, TranslatedEnd } from "../pkg/quatlas.js";
import wholeUrl from "../pkg/quatlas_bg.wasm?url";
import * as small from "../pkg/small/quatlas_small.js";
import smallUrl from "../pkg/small/quatlas_small_bg.wasm?url";
import { answering, type Core, CoreStopped } from "./package/answering.ts";

export type * from "../pkg/quatlas.js";

/** What the core could not answer, in words; a mistake of ours, never of the text. */
export interface Failure {
  status: "failure";
  message: string;
}

/** The small core answers Read and Compose, and the page begins with it; the whole core answers all. */
export interface Engine extends ReturnType<typeof small.presets> {
  views: readonly Request["view"][];
  /** What libraries do, in the order of the table; only the whole core has it. */
  libraries: readonly Library[];
  /** The answer to a request. It never throws. */
  analyze: (request: Request) => Outcome | Failure;
  /** What a library of the table does by itself, with an example; nothing for another id. */
  endOf: (id: string) => TranslatedEnd | undefined;
}

export async function loadSmallEngine(): Promise<Engine> {
  await small.default({ module_or_path: smallUrl });
  return {
    views: ["read", "compose"],
    ...small.presets(),
    libraries: [],
    analyze: analyzing(small),
    endOf: () => undefined,
  };
}

let loadedWhole: Promise<Engine> | undefined;

/** Loads the whole core once; again only where that failed. */
export function loadWholeEngine(): Promise<Engine> {
  loadedWhole ??= fetchWholeEngine().catch((error: unknown) => {
    loadedWhole = undefined;
    throw error;
  });
  return loadedWhole;
}

async function fetchWholeEngine(): Promise<Engine> {
  const whole = await import("../pkg/quatlas.js");
  await whole.default({ module_or_path: wholeUrl });
  const analyze = analyzing(whole);
  return {
    views: ["read", "compose", "translate", "identify"],
    ...whole.presets(),
    libraries: JSON.parse(whole.librariesJson()),
    analyze,
    endOf: remembered((id) => endOf(id, analyze)),
  };
}

/** The end that a library is when nothing is said beyond its record. */
function endOf(id: string, analyze: Engine["analyze"]): TranslatedEnd | undefined {
  const end = { kind: "library", id } as const;
  const answer = analyze({ view: "translate", quaternion: "1 2 3 4", from: end, to: end });
  return answer.status === "translate" ? answer.from : undefined;
}

function remembered<Value>(of: (id: string) => Value): (id: string) => Value {
  const known = new Map<string, Value>();
  return (id) => {
    if (!known.has(id)) known.set(id, of(id));
    return known.get(id) as Value;
  };
}

function analyzing(core: Core): Engine["analyze"] {
  const answer = answering(core);
  return (request) => {
    try {
      return answer(request);
    } catch (error) {
      const message = error instanceof CoreStopped ? error.reason : String(error);
      return { status: "failure", message };
    }
  };
}
