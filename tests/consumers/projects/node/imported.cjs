require("../check.js");

import("quatlas").then((quatlas) => console.log(checkQuatlas(quatlas)));
