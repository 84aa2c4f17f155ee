import "../check.js";
import * as quatlas from "quatlas";

postMessage(checkQuatlas(quatlas));
