import "../check.js";
import * as quatlas from "quatlas";

/** Of the same name as a function of quatlas. */
export const read = () => checkQuatlas(quatlas);
