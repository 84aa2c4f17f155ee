// The entry `quatlas/web`: everything, with the wasm in a file beside it, which `init` fetches.
import load from "../../pkg/quatlas.js";
import urlOfWasm from "../../pkg/quatlas_bg.wasm?beside";
import { explained } from "./compiled.ts";
import { startCoreBy } from "./core.ts";
import { conventionOfLibrary } from "./named_libraries.ts";
import { nameConventionsBy } from "./numbers/choices.ts";
import { QuatlasError } from "./quatlas_error.ts";

export * from "./conventions.ts";
export * from "./libraries.ts";
export * from "./numbers/index.ts";
export * from "./texts.ts";

nameConventionsBy(conventionOfLibrary);

startCoreBy(() => {
  throw new QuatlasError(
    "not-loaded",
    "quatlas/web is not loaded yet",
    "`await init()` first, its default export",
  );
});

/** Where the wasm comes from: its address, an answer with it, its bytes, or the compiled module. */
export type WasmSource =
  | string
  | URL
  | Request
  | Response
  | BufferSource
  | WebAssembly.Module
  | Promise<Response | BufferSource | WebAssembly.Module>;

/** What `init` may be told. */
export interface InitOptions {
  /** The file `quatlas/quatlas_bg.wasm`; it is fetched from beside the script where this is not given. */
  wasm?: WasmSource;
}

/**
 * Fetches and compiles the core, once; what asks the core can be called when this is done.
 *
 * A bundler that leaves the file behind needs to be told of it: `init({ wasm: urlOfTheFile })`.
 *
 * @example
 * import init, { JPL, read } from "quatlas/web";
 * await init();
 * read({ quaternion: "0 0 √½ √½", vector: "1 0 0", convention: JPL }).jpl.image; // [0, -1, 0]
 */
export default async function init(options: InitOptions = {}): Promise<void> {
  try {
    await load({ module_or_path: options.wasm ?? urlOfWasm() });
  } catch (cause) {
    throw explained(cause);
  }
  startCoreBy(() => {});
}
