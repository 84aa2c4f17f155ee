// The one door to the core: the only file of the page that imports the wasm.
import type {
  Convention,
  ConventionDescription,
  Library,
  LibraryDescription,
  Outcome,
  Probe as ProbeOfCore,
  Request,
  Text,
} from "../pkg/quatlas.js";
import wholeUrl from "../pkg/quatlas_bg.wasm?url";
import loadSmall, {
  analyze,
  describeConvention,
  readNumber,
  startAnew,
  takePanicMessage,
} from "../pkg/small/quatlas_small.js";
import smallUrl from "../pkg/small/quatlas_small_bg.wasm?url";
import { answering, type Core, CoreStopped, calling } from "./package/answering.ts";

export type * from "../pkg/quatlas.js";

/** An observation as the page has it: only a program gives numbers in place of texts. */
export type Probe = OfTexts<ProbeOfCore>;
type OfTexts<Asked> = Asked extends unknown
  ? { [Name in keyof Asked]: Text extends Asked[Name] ? string : Asked[Name] }
  : never;

/** What the core could not answer, in words; a mistake of ours, never of the text. */
export interface Failure {
  status: "failure";
  message: string;
}

/** What a convention is called and does. */
export type Describe = (
  convention: Convention,
) => ConventionDescription & { preset: "hamilton" | "jpl" | undefined };

/**
 * The small core answers Read and Compose for what most people type, and the page begins with it; the whole
 * core answers all, and never otherwise than the small one where that one has an answer.
 */
export interface Engine {
  /** Whether a text with a problem has one for quatlas, and not for the small core alone. */
  isWhole: boolean;
  /** What libraries do, in the order of the table; it comes with the whole core. */
  libraries: readonly Library[];
  /** The probes that are proposed, one of each kind; only the whole core has them. */
  standardProbes: readonly Probe[];
  /** The answer to a request. It never throws. */
  analyze: (request: Request) => Outcome | Failure;
  describe: Describe;
  /** What a library of the table does by itself; nothing for another id. */
  describeLibrary: (id: string) => LibraryDescription | undefined;
  /** The one number that a text holds; nothing where it holds none, or several. It never throws. */
  readNumber: (text: string) => number | undefined;
}

/** What is called of either core. */
interface EitherCore extends Core {
  describeConvention: (convention: Convention) => ConventionDescription;
  readNumber: (text: string) => number | undefined;
}

// One by one, so that what is not named here is not in the script. The small core answers fewer views.
const small: EitherCore = {
  analyze: analyze as Core["analyze"],
  describeConvention,
  readNumber,
  startAnew,
  takePanicMessage,
};

/** What first.js asked for before this script was there. */
declare global {
  var askedFirst: { url: string; answer: Promise<Response> } | undefined;
}

/** The answer that is on its way already, the first time; or else the address to ask for. */
function askedFor(url: string): string | Promise<Response> {
  const { askedFirst } = globalThis;
  if (askedFirst?.url !== new URL(url, document.baseURI).href) return url;
  globalThis.askedFirst = undefined;
  return askedFirst.answer;
}

/** The bytes of the core are given where there is no server to fetch them from. */
export async function loadSmallEngine(bytes?: BufferSource): Promise<Engine> {
  await loadSmall({ module_or_path: bytes ?? askedFor(smallUrl) });
  return {
    isWhole: false,
    libraries: [],
    standardProbes: [],
    ...answersOf(small, calling(small)),
    describeLibrary: () => undefined,
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
  const [whole, { default: libraries }] = await Promise.all([
    loadWholeCore(),
    import("../src/library/libraries.json"),
  ]);
  const call = calling(whole);
  return {
    isWhole: true,
    libraries: libraries as Library[],
    standardProbes: whole.standardProbes() as Probe[],
    ...answersOf(whole, call),
    describeLibrary: remembered((id) => call(() => whole.describeLibrary(id))),
  };
}

async function loadWholeCore() {
  const {
    default: load,
    analyze,
    describeConvention,
    describeLibrary,
    readNumber,
    standardProbes,
    startAnew,
    takePanicMessage,
  } = await import("../pkg/quatlas.js");
  await load({ module_or_path: askedFor(wholeUrl) });
  return {
    analyze,
    describeConvention,
    describeLibrary,
    readNumber,
    standardProbes,
    startAnew,
    takePanicMessage,
  };
}

/** What both cores answer. */
function answersOf(core: EitherCore, call: ReturnType<typeof calling>) {
  const answer = answering(core, call);
  const described = remembered(
    (_, convention: Convention) =>
      call(() => core.describeConvention(convention)) as ReturnType<Describe>,
  );
  return {
    analyze: (request: Request): Outcome | Failure => {
      try {
        return answer(request);
      } catch (error) {
        const message = error instanceof CoreStopped ? error.reason : String(error);
        return { status: "failure", message };
      }
    },
    describe: (convention: Convention) => {
      const { order, handedness, function: does, direction, perturbation } = convention;
      return described([order, handedness, does, direction, perturbation].join(), convention);
    },
    readNumber: (text: string) => {
      try {
        return call(() => core.readNumber(text));
      } catch {
        return undefined;
      }
    },
  };
}

/** A function that computes once for each key. */
function remembered<Rest extends unknown[], Value>(
  of: (key: string, ...rest: Rest) => Value,
): (key: string, ...rest: Rest) => Value {
  const known = new Map<string, Value>();
  return (key, ...rest) => {
    if (!known.has(key)) known.set(key, of(key, ...rest));
    return known.get(key) as Value;
  };
}
