import "../check.js";
import * as quatlas from "../node_modules/quatlas/dist/npm/index.mjs";

postMessage(checkQuatlas(quatlas));
