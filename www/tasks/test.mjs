// npm test: set up what is missing, then every check, the fast ones first.
// `npm test -- rust page` runs only the named steps.
import { existsSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { setUpEngines } from "./engines.mjs";
import { buildPackage } from "./package.mjs";
import { buildCore, setUp, setUpRustChecks } from "./setup.mjs";
import { main, root, run, runTogether, Stop, say } from "./shell.mjs";

const warningsAreErrors = ["--", "-D", "warnings"];

/** The engines that the page was tested in. */
let covered = [];

const steps = {
  format: async () => {
    await setUpRustChecks();
    run("cargo", "fmt", "--check");
    run("biome", "ci", "--error-on-warnings", "--config-path=.ci", "www", "tests", "bench");
  },
  rust: async () => {
    await setUpRustChecks();
    run("cargo", "clippy", "--locked", "--all-targets", ...warningsAreErrors);
    const wasm = ["--target", "wasm32-unknown-unknown"];
    run("cargo", "clippy", "--locked", "--all-targets", ...wasm, ...warningsAreErrors);
    const small = [...wasm, "--no-default-features"];
    run("cargo", "clippy", "--locked", ...small, ...warningsAreErrors);
    const numbers = [...small, "--features", "rotations"];
    run("cargo", "clippy", "--locked", ...numbers, ...warningsAreErrors);
    run("cargo", "test", "--locked");
    process.env.RUSTDOCFLAGS = "-D warnings";
    run("cargo", "doc", "--locked", "--no-deps");
    run("cargo", "doc", "--locked", "--no-deps", ...wasm);
  },
  types: async () => {
    await buildCore();
    run("tsc", "-p", "www");
  },
  package: async () => {
    await buildCore();
    await buildPackage();
    run(process.execPath, "--test", "tests/node/", "tests/consumers/");
  },
  wasm: async () => {
    // wasm-bindgen is there once the core is built; two at once would both install it.
    await buildCore();
    // Each crate of tests runs on one core, and the longest takes as long as all others.
    const [longest, ...others] = testCrates();
    const test = ["wasm-pack", "test", "--node", "--"];
    const named = (names) => names.flatMap((name) => ["--test", name]);
    return runTogether([...test, ...named([longest])], [...test, "--lib", ...named(others)]);
  },
  page: async () => {
    covered = await setUpEngines();
    await buildCore();
    say("building the page");
    run("vite", "build", "--config", "www/vite.config.ts", "--logLevel", "warn");
    run("playwright", "test", "--config", "tests/browser/playwright.config.ts");
  },
};

/** The crates of tests that also run in wasm: the folders with a main.rs, the longest first. */
function testCrates() {
  const folders = readdirSync(join(root, "tests"));
  const crates = folders.filter((name) => existsSync(join(root, "tests", name, "main.rs")));
  return crates.sort((one, other) => Number(other === "library") - Number(one === "library"));
}

await main(async () => {
  if (!existsSync(join(root, "Cargo.lock"))) throw new Stop("this is not a checkout of quatlas");
  const asked = process.argv.slice(2);
  const unknown = asked.find((name) => !(name in steps));
  if (unknown !== undefined) {
    throw new Stop(`there is no step ${unknown}; there are ${Object.keys(steps).join(", ")}`);
  }
  await setUp();
  const chosen = Object.entries(steps).filter(
    ([name]) => asked.length === 0 || asked.includes(name),
  );
  for (const [name, step] of chosen) {
    say(`testing: ${name}`);
    await step();
  }
  if (covered.length > 0) console.log(`engines: ${covered.join(", ")}`);
  console.log(`steps: ${chosen.length} passed, 0 failed`);
});
