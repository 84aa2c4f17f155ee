// A core out of its bytes.
import { QuatlasError } from "./quatlas_error.ts";

/** The module of these bytes; an error that names the cure where the policy of the page forbids it. */
export function compiled(bytes: Uint8Array<ArrayBuffer>): WebAssembly.Module {
  try {
    return new WebAssembly.Module(bytes);
  } catch (cause) {
    throw explained(cause);
  }
}

/** What keeps a core from being compiled, with the cure where there is one. */
export function explained(cause: unknown): unknown {
  if (
    !(cause instanceof Error && /content security policy|unsafe-eval|\bCSP\b/i.test(cause.message))
  ) {
    return cause;
  }
  const message = "the Content-Security-Policy of the page forbids WebAssembly";
  return new QuatlasError("no-wasm", message, "add 'wasm-unsafe-eval' to its script-src", {
    cause,
  });
}
