import * as rotation from "../node_modules/quatlas/dist/npm/rotation.mjs";

document.title = checkRotation(rotation, rotation);
