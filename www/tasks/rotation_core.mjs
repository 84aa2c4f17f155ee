// The core of numbers alone: built for speed, and without the words that a panic would have.
import { readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { root, runQuietly, Stop } from "./shell.mjs";

const folder = join("pkg", "rotation");
const wasm = join(folder, "quatlas_rotation_bg.wasm");
const types = join(root, folder, "quatlas_rotation.d.ts");

const build = { task: "build the core of numbers", advice: "mend what the compiler names" };

// Named one by one, as in Cargo.toml.
const features = [
  "bulk-memory",
  "multivalue",
  "mutable-globals",
  "nontrapping-float-to-int",
  "reference-types",
  "sign-ext",
].map((feature) => `--enable-${feature}`);

/** A third of the file, for what never happens: without its words a panic traps, which is told as well. */
const neverCalled =
  /panicking::panic(_fmt)?"?$|option::unwrap_failed"?$|alloc::handle_alloc_error"?$/;

export async function buildRotationCore() {
  const named = ["--out-dir", folder, "--out-name", "quatlas_rotation", "--no-pack", "--no-opt"];
  const chosen = ["--profile", "rotations", "--target", "web", ...named];
  const only = ["--", "--no-default-features", "--features", "rotations"];
  await runQuietly(build, "wasm-pack", "build", ...chosen, ...only);
  const text = join(root, folder, "whole.wat");
  await runQuietly(build, "wasm-dis", wasm, ...features, "-o", text);
  writeFileSync(text, withoutBodies(readFileSync(text, "utf8")));
  // It inlines nothing, which makes the file smaller when it is compressed, and no call slower.
  const size = ["-aimfs", "0", "-ocimfs", "0", "-fimfs", "0", "--low-memory-unused"];
  const strip = ["--strip-debug", "--strip-producers", "--strip-target-features"];
  await runQuietly(build, "wasm-opt", text, "-O3", ...size, ...strip, ...features, "-o", wasm);
  rmSync(text);
  // The types of requests and reports are those of the whole core, which has all of them.
  const declared = readFileSync(types, "utf8");
  const first = declared.search(/\/\*\*(?:(?!\*\/)[\s\S])*\*\/\s*export (enum|function)/);
  writeFileSync(types, declared.slice(first));
}

/** The functions that are never called, each of which only traps. */
function withoutBodies(text) {
  let found = 0;
  const cut = text.replace(
    /^ \(func \$("[^"]*"|\S+)(.*)\n(?: {2}.*\n)* \)$/gm,
    (whole, name, rest) => {
      if (!neverCalled.test(name)) return whole;
      found += 1;
      return ` (func $${name}${rest}\n  (unreachable)\n )`;
    },
  );
  const pointer = text.match(/^ \(global (\S*__stack_pointer\S*) /m)?.[1];
  if (found < 3 || pointer === undefined) {
    throw new Stop("the core of numbers has no panics or no stack by the names that were known");
  }
  // After a call that ran out of stack it is set back, from outside.
  return cut.replace(/^ \(export /m, ` (export "stackPointer" (global ${pointer}))\n (export `);
}
