require("../check_rotation.js");

console.log(checkRotation(require("quatlas/rotation"), require("quatlas")));
