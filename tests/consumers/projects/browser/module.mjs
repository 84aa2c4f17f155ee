import * as quatlas from "../node_modules/quatlas/dist/npm/index.mjs";

if ("quatlas" in globalThis) throw new Error("a module left a global behind");
document.title = checkQuatlas(quatlas);
