require("../check.js");

console.log(checkQuatlas(require("quatlas")));
