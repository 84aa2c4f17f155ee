import init, * as quatlas from "../node_modules/quatlas/dist/npm/web.mjs";

await init();
document.title = checkQuatlas(quatlas);
