import "../check.js";
import { HAMILTON, identifyNumbers, JPL, libraries, read, translate } from "quatlas";

document.title = checkQuatlas({ HAMILTON, identifyNumbers, JPL, libraries, read, translate });
