import libraries from "quatlas/libraries.json" with { type: "json" };

console.log(libraries.map(({ id }) => id.length));
