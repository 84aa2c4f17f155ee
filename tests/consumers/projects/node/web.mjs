import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import "../check.js";
import init, * as quatlas from "quatlas/web";

try {
  checkQuatlas(quatlas);
  throw new Error("it answered before it was loaded");
} catch ({ message }) {
  if (!/await init\(\)/.test(message)) throw new Error(message);
}
const bytes = readFileSync(createRequire(import.meta.url).resolve("quatlas/quatlas_bg.wasm"));
const headers = { "Content-Type": "application/wasm" };
const sources = {
  bytes: () => bytes,
  module: () => new WebAssembly.Module(bytes),
  response: () => new Response(bytes, { headers }),
  promise: async () => new Response(bytes, { headers }),
};
await init({ wasm: sources[process.argv[2]]() });
console.log(checkQuatlas(quatlas));
