import * as quatlas from "quatlas";

document.title = checkQuatlas(quatlas);
