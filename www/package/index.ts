// The entry `quatlas`: everything, with the wasm inside, ready when the import is.
import { initSync } from "../../pkg/quatlas.js";
import wasm from "../../pkg/quatlas_bg.wasm?packed";
import { compiled } from "./compiled.ts";
import { startCoreBy } from "./core.ts";
import { unpacked } from "./packed.ts";

export * from "./conventions.ts";
export * from "./libraries.ts";
export * from "./texts.ts";

startCoreBy(() => void initSync({ module: compiled(unpacked(wasm)) }));
