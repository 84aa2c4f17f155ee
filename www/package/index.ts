// The entry `quatlas`: everything, with the wasm inside, ready when the import is.
import { initSync } from "../../pkg/quatlas.js";
import wasm from "../../pkg/quatlas_bg.wasm?packed";
import { compiled } from "./compiled.ts";
import { startCoreBy } from "./core.ts";
import { conventionOfLibrary } from "./named_libraries.ts";
import { nameConventionsBy } from "./numbers/choices.ts";
import { unpacked } from "./packed.ts";

export * from "./conventions.ts";
export * from "./libraries.ts";
export * from "./numbers/index.ts";
export * from "./texts.ts";

nameConventionsBy(conventionOfLibrary);

startCoreBy(() => void initSync({ module: compiled(unpacked(wasm)) }));
