// What the glue of wasm-bindgen needs as soon as it is loaded, also where it is no global: in a test in jsdom.
const util = globalThis.process?.getBuiltinModule?.("node:util");

export const TextDecoder = globalThis.TextDecoder ?? util?.TextDecoder;
export const TextEncoder = globalThis.TextEncoder ?? util?.TextEncoder;
