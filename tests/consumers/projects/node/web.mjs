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
const file = createRequire(import.meta.url).resolve("quatlas/quatlas_bg.wasm");
await init({ wasm: readFileSync(file) });
console.log(checkQuatlas(quatlas));
