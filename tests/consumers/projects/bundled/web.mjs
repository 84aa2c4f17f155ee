import "../check.js";
import init, * as quatlas from "quatlas/web";

init().then(() => {
  document.title = checkQuatlas(quatlas);
});
