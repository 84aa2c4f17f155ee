// npm run long: what is too slow for npm test. `npm run long -- relations --times 100 --seed 3` runs
// only the named suites, with so many times the cases of npm test (30 where it is not said), from
// another seed. `npm run long -- consumers` tries the package wherever it can be imported.
import { join } from "node:path";
import { parseArgs } from "node:util";
import { buildPackage } from "./package.mjs";
import { buildCore, setUp } from "./setup.mjs";
import { main, run, Stop, say } from "./shell.mjs";

const suites = {
  /** The properties of `cargo test`, optimised, and still with every check of arithmetic. */
  relations: ({ times, seed }) => {
    process.env.QUATLAS_TIMES = times;
    if (seed !== undefined) process.env.QUATLAS_SEED = seed;
    process.env.CARGO_PROFILE_DEV_OPT_LEVEL = "2";
    process.env.CARGO_TARGET_DIR = "target/long";
    const crates = ["--test", "text", "--test", "library"];
    run("cargo", "test", "--locked", "--no-fail-fast", ...crates, "properties::");
  },
  /** The packed package in all environments, which are installed from the registry: some minutes. */
  consumers: async () => {
    await buildCore();
    await buildPackage();
    run(process.execPath, join("tests", "consumers", "all.mjs"));
  },
};

await main(async () => {
  const { values, asked } = options();
  const unknown = asked.find((name) => !(name in suites));
  if (unknown !== undefined) {
    throw new Stop(`there is no suite ${unknown}; there are ${Object.keys(suites).join(", ")}`);
  }
  await setUp();
  const chosen = Object.entries(suites).filter(
    ([name]) => asked.length === 0 || asked.includes(name),
  );
  for (const [name, suite] of chosen) {
    say(`testing at length: ${name}`);
    await suite(values);
  }
  console.log(`suites: ${chosen.length} passed, 0 failed`);
});

function options() {
  const whole = { type: "string" };
  try {
    const { values, positionals } = parseArgs({
      allowPositionals: true,
      options: { times: { ...whole, default: "30" }, seed: whole },
    });
    for (const [name, value] of Object.entries(values)) {
      if (!/^[0-9]{1,9}$/.test(value))
        throw new Stop(`--${name} takes a whole number, not ${value}`);
    }
    return { values, asked: positionals };
  } catch (error) {
    throw error instanceof Stop ? error : new Stop(error.message);
  }
}
