import "../check_rotation.js";
import * as everything from "quatlas";
import * as rotation from "quatlas/rotation";

checkRotation(everything, rotation);
console.log(checkRotation(rotation, everything));
