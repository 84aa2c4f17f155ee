// The npm package's door: the core with its wasm inside, ready when the import is.
import {
  analyze as analyzeInCore,
  type Convention,
  initSync,
  type Outcome,
  presets,
  type Request,
  takePanicMessage,
} from "../../pkg/quatlas.js";
import wasm from "../../pkg/quatlas_bg.wasm?url&inline";

export type * from "../../pkg/quatlas.js";

initSync({ module: bytesOfDataUrl(wasm) });

const named = presets();

/** Hamilton: `[w, x, y, z]`, ij = k, passive, body to world, local perturbation. */
export const HAMILTON: Convention = Object.freeze(named.hamilton);

/** JPL (Shuster): `[x, y, z, w]`, ij = −k, passive, world to body, local perturbation. */
export const JPL: Convention = Object.freeze(named.jpl);

/**
 * The answer to a request: a report with notes, or the problems of its texts.
 *
 * What is typed never throws: a text that cannot be read comes back as `status: "problems"`, each
 * with a code, a span in UTF-16 units, what was expected and what to try. A `TypeError` says that
 * the request is not of its type.
 *
 * @example
 * // x y z w of a JPL filter, world to body: a quarter turn about z
 * const outcome = analyze({ view: "read", quaternion: "0 0 √½ √½", vector: "1 0 0", convention: JPL });
 * outcome.jpl.image; // [0, -1, 0]: the world's x axis lies along the body's −y
 */
export function analyze(request: Request): Outcome {
  try {
    return analyzeInCore(request);
  } catch (error) {
    const panic = takePanicMessage();
    if (panic === undefined) throw error;
    throw new Error(`this is a mistake in quatlas, please report it: ${panic}`, { cause: error });
  }
}

function bytesOfDataUrl(url: string): Uint8Array<ArrayBuffer> {
  const binary = atob(url.slice(url.indexOf(",") + 1));
  return Uint8Array.from(binary, (character) => character.charCodeAt(0));
}
