// What benches compare with: an earlier commit, in a git worktree of its own, built by its own commands.
import { existsSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { ask, root, runQuietly, Stop, say } from "./shell.mjs";

/** The same for every ratio that is told. */
export const BASELINE = "0889617";

const folder = join(root, "target", "baseline", BASELINE);
const stamp = join(folder, "dist", ".built");
const advice = "check the network connection and run this again";

/** The folder of the baseline, with its page in dist/page and its package in dist/npm; built once, then kept. */
export async function baseline() {
  const commit = ask("git", "rev-parse", "--verify", "--quiet", BASELINE);
  if (commit === undefined) {
    throw new Stop(
      `there is no commit ${BASELINE} to compare with: run this in a clone with its whole history (git fetch --unshallow)`,
    );
  }
  if (existsSync(stamp) && readFileSync(stamp, "utf8") === commit) return folder;
  say(`building the baseline, ${BASELINE}, in ${folder} (first time only, some minutes)`);
  if (!existsSync(join(folder, "package.json"))) await checkOut(commit);
  // What it compiles stays apart from what this tree does.
  const { CARGO_TARGET_DIR: _, ...environment } = process.env;
  const build = { task: "build the baseline", advice, folder, environment };
  await runQuietly(build, process.execPath, "www/tasks/prepack.mjs");
  const vite = join("node_modules", "vite", "bin", "vite.js");
  const page = ["build", "--config", "www/vite.config.ts", "--logLevel", "warn"];
  await runQuietly(build, process.execPath, vite, ...page);
  writeFileSync(stamp, commit);
  return folder;
}

async function checkOut(commit) {
  rmSync(folder, { recursive: true, force: true });
  const add = { task: "check the baseline out", advice: "look at what git says" };
  // By force: git may still know a folder that was deleted.
  await runQuietly(add, "git", "worktree", "add", "--force", "--detach", folder, commit);
}
