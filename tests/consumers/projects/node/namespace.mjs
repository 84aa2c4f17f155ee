import "../check.js";
import * as quatlas from "quatlas";

console.log(checkQuatlas(quatlas));
