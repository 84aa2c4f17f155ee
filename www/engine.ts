// The one door to the core: the only file of the page that imports the wasm.
import init, {
  analyze as analyzeInCore,
  type Convention,
  type Library,
  librariesJson,
  type Outcome,
  presets,
  type Request,
  type TranslatedEnd,
  takePanicMessage,
} from "../pkg/quatlas.js";
import wasmUrl from "../pkg/quatlas_bg.wasm?url";

export type * from "../pkg/quatlas.js";

/** What the core could not answer, in words; a mistake of ours, never of the text. */
export interface Failure {
  status: "failure";
  message: string;
}

export interface Engine {
  hamilton: Convention;
  jpl: Convention;
  /** What libraries do, in the order of the table. */
  libraries: readonly Library[];
  /** The answer to a request. It never throws. */
  analyze: (request: Request) => Outcome | Failure;
  /** What a library of the table does by itself, with an example; nothing for another id. */
  endOf: (id: string) => TranslatedEnd | undefined;
}

export async function loadEngine(): Promise<Engine> {
  await init({ module_or_path: wasmUrl });
  const { hamilton, jpl } = presets();
  return { hamilton, jpl, libraries: readLibraries(), analyze, endOf: remembered(endOf) };
}

/** The end that a library is when nothing is said beyond its record. */
function endOf(id: string): TranslatedEnd | undefined {
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

/** Every object inherits a `constructor`: a record without one must say so itself. */
function readLibraries(): readonly Library[] {
  const records: Library[] = JSON.parse(librariesJson());
  return records.map((record) => ({ ...noConstructor, ...record }));
}

const noConstructor = { constructor: undefined };

function analyze(request: Request): Outcome | Failure {
  try {
    return analyzeInCore(request);
  } catch (error) {
    return { status: "failure", message: panicMessage() ?? String(error) };
  }
}

/** What a panic said; the core that panicked may not be able to tell. */
function panicMessage(): string | undefined {
  try {
    return takePanicMessage();
  } catch {
    return undefined;
  }
}
