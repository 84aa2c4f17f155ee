// What a fresh machine lacks is installed here, each thing once, each with one line.
import { createHash } from "node:crypto";
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { buildRotationCore } from "./rotation_core.mjs";
import { ask, exists, root, runQuietly, Stop, say } from "./shell.mjs";
import { areValuesWritten, writeValues } from "./values.mjs";

const OLDEST_NODE = 20;
const OLDEST_RUST = [1, 89];
/** Older ones do not know the options that the build uses. */
const OLDEST_WASM_PACK = [0, 13];
const WASM_PACK = "0.15.1";
const WASM = "wasm32-unknown-unknown";
const network = "check the network connection and run this again";

export async function setUp() {
  checkNode();
  checkRust();
  await installNodeModules();
  await addWasmTarget();
  await installWasmPack();
}

function checkNode() {
  const [major] = process.versions.node.split(".").map(Number);
  if (major < OLDEST_NODE) {
    throw new Stop(
      `Node ${OLDEST_NODE} or newer is needed and this is ${process.versions.node}: install it from https://nodejs.org`,
    );
  }
}

function checkRust() {
  const version = ask("cargo", "--version");
  if (version === undefined) {
    throw new Stop(
      "cargo was not found: install Rust from https://rustup.rs, open a new terminal and run this again",
    );
  }
  if (isOlder(version, OLDEST_RUST)) {
    throw new Stop(
      `Rust ${OLDEST_RUST.join(".")} or newer is needed and this is ${version}: run "rustup update stable"`,
    );
  }
}

/** Whether the first version number in a text is older than another. */
function isOlder(text, [oldestMajor, oldestMinor]) {
  const [, major, minor] = text.match(/(\d+)\.(\d+)/)?.map(Number) ?? [0, 0, 0];
  return major < oldestMajor || (major === oldestMajor && minor < oldestMinor);
}

async function installNodeModules() {
  const lock = createHash("sha256")
    .update(readFileSync(join(root, "package-lock.json")))
    .digest("hex");
  const stamp = join(root, "node_modules", ".quatlas-lock");
  if (existsSync(stamp) && readFileSync(stamp, "utf8") === lock) return;
  say("installing the node modules of the lock file (first time only, under a minute)");
  const npm = process.env.npm_execpath;
  const [command, ...args] = npm?.endsWith("js") ? [process.execPath, npm] : ["npm"];
  const install = { task: "install the node modules", advice: network };
  await runQuietly(install, command, ...args, "ci", "--no-audit", "--no-fund");
  writeFileSync(stamp, lock);
}

async function addWasmTarget() {
  const folder = ask("rustc", "--print", "target-libdir", "--target", WASM);
  if (folder !== undefined && existsSync(folder)) return;
  if (ask("rustup", "--version") === undefined) {
    throw new Stop(
      `this Rust has no ${WASM} target and there is no rustup to add it: install Rust from https://rustup.rs`,
    );
  }
  say(`adding the Rust target ${WASM} (first time only, under a minute)`);
  const add = { task: "add the wasm target", advice: network };
  await runQuietly(add, "rustup", "target", "add", WASM);
}

async function installWasmPack() {
  const version = ask("wasm-pack", "--version");
  if (version !== undefined && !isOlder(version, OLDEST_WASM_PACK)) return;
  say(`installing wasm-pack ${WASM_PACK} with cargo (first time only, about three minutes)`);
  await runQuietly(
    { task: "install wasm-pack", advice: network },
    "cargo",
    "install",
    "wasm-pack",
    "--version",
    WASM_PACK,
    "--locked",
    "--force",
  );
}

/** What only the checks of the Rust code need; a minimal toolchain does not have it. */
export async function setUpRustChecks() {
  const missing = ["clippy", "rustfmt"].filter((component) => {
    const command = component === "rustfmt" ? "fmt" : component;
    return ask("cargo", command, "--version") === undefined;
  });
  if (missing.length === 0) return;
  say(`adding ${missing.join(" and ")} to the Rust toolchain (first time only)`);
  const add = { task: `add ${missing.join(" and ")}`, advice: network };
  await runQuietly(add, "rustup", "component", "add", ...missing);
}

/** Builds the three cores and what the page knows of them, unless nothing they are made of has changed. */
export async function buildCore() {
  const inputs =
    ask("git", "ls-files", "-co", "--exclude-standard", "src")?.split("\n").sort() ?? [];
  const hash = createHash("sha256");
  const tasks = ["rotation_core.mjs", "setup.mjs", "values.mjs"].map((file) =>
    join("www", "tasks", file),
  );
  for (const file of ["Cargo.toml", "Cargo.lock", "package-lock.json", ...tasks, ...inputs]) {
    if (exists(file)) hash.update(file).update(readFileSync(join(root, file)));
  }
  const fingerprint = hash.digest("hex");
  const stamp = join(root, "pkg", ".fingerprint");
  const isBuilt = inputs.length > 0 && existsSync(stamp);
  if (isBuilt && readFileSync(stamp, "utf8") === fingerprint) {
    if (!areValuesWritten()) await writeValues();
    return;
  }
  say(
    "building the core with wasm-pack (the first time it may build wasm-bindgen too: some minutes; later seconds)",
  );
  const small = join("pkg", "small");
  await buildWasm(small, "--out-name", "quatlas_small", "--", "--no-default-features");
  await buildWasm("pkg", "--out-name", "quatlas");
  await buildRotationCore();
  await writeValues();
  writeFileSync(stamp, fingerprint);
}

function buildWasm(folder, ...options) {
  return runQuietly(
    { task: "build the core", advice: "mend what the compiler names, or check the network" },
    "wasm-pack",
    "build",
    "--release",
    "--target",
    "web",
    "--out-dir",
    folder,
    "--no-pack",
    ...options,
  );
}
