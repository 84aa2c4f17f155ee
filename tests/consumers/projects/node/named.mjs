import "../check.js";
import { HAMILTON, identifyNumbers, JPL, libraries, read, translate } from "quatlas";

console.log(checkQuatlas({ HAMILTON, identifyNumbers, JPL, libraries, read, translate }));
