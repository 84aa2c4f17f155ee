const { libraries } = require("quatlas");

const [table, { observations }] = ["libraries", "observations"].map((name) =>
  require(`quatlas/${name}.json`),
);
const isSame = JSON.stringify(table) === JSON.stringify(libraries);
console.log(isSame && observations.length > 60 ? "ok" : "the tables differ");
