// A wasm inside a script: deflated, in base64. Node, Deno and Bun have what unpacks it; for a browser it is here.

/** What `www/tasks/wasm_in_scripts.mjs` makes of a wasm. */
export interface Packed {
  /** How many bytes it has, so that it is unpacked in one piece. */
  size: number;
  base64: string;
}

/** The bytes of a wasm. */
export function unpacked({ size, base64 }: Packed): Uint8Array<ArrayBuffer> {
  const deflated = bytesOf(base64);
  const zlib = globalThis.process?.getBuiltinModule?.("node:zlib");
  if (zlib !== undefined) return zlib.inflateRawSync(deflated, { chunkSize: size });
  // An import would make its tables, for a third of the time of an import of quatlas, also where they are not used.
  const { inflateSync } = require("./inflate.ts") as typeof import("./inflate.ts");
  return inflateSync(deflated, { out: new Uint8Array(size) });
}

/** The newest way first: a loop over what `atob` gives is the slowest, and everywhere. */
function bytesOf(base64: string): Uint8Array {
  if ("fromBase64" in Uint8Array) {
    return (Uint8Array.fromBase64 as (text: string) => Uint8Array)(base64);
  }
  if (typeof Buffer === "function") return Buffer.from(base64, "base64");
  const binary = atob(base64);
  const bytes = new Uint8Array(binary.length);
  for (let at = 0; at < bytes.length; at += 1) bytes[at] = binary.charCodeAt(at);
  return bytes;
}
