importScripts("../check.js", "../node_modules/quatlas/dist/npm/quatlas.js");

postMessage(checkQuatlas(quatlas));
