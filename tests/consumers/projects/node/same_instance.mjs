import { createRequire } from "node:module";
import "../check.js";
import * as imported from "quatlas";

const required = createRequire(import.meta.url)("quatlas");
for (const [name, value] of Object.entries(imported)) {
  if (required[name] !== value) throw new Error(`${name} is another one`);
}
console.log(checkQuatlas(required));
