// Running other programs, and ending in one plain line when something is missing.
import { spawn, spawnSync } from "node:child_process";
import { createWriteStream, existsSync, mkdirSync } from "node:fs";
import { homedir } from "node:os";
import { delimiter, join } from "node:path";
import { fileURLToPath } from "node:url";

export const root = fileURLToPath(new URL("../..", import.meta.url));
const isWindows = process.platform === "win32";

/** How much of a program's output is searched for the reason of its failure. */
const longestReason = 20_000;

/** A reason to end that the person at the keyboard can do something about. */
export class Stop extends Error {}

// What cargo and npm install is found by its place, not by what the shell was told before.
const cargoHome = process.env.CARGO_HOME ?? join(homedir(), ".cargo");
process.env.PATH = [
  join(root, "node_modules", ".bin"),
  process.env.PATH,
  join(cargoHome, "bin"),
].join(delimiter);

export function say(line) {
  console.log(`quatlas: ${line}`);
}

/** What a program prints, or undefined where there is no such program or it fails. */
export function ask(command, ...args) {
  const { status, stdout } = spawnSync(command, args, {
    cwd: root,
    encoding: "utf8",
    shell: isWindows,
  });
  return status === 0 ? stdout.trim() : undefined;
}

/** Runs a program with its output on the screen. */
export function run(command, ...args) {
  const { status } = spawnSync(command, args, {
    cwd: root,
    stdio: "inherit",
    shell: isWindows,
  });
  if (status !== 0) throw new Stop(`${[command, ...args].join(" ")} failed; its words are above`);
}

/** The exit code of a program whose output is handed on as it comes; undefined where there is no such program. */
function listenTo(command, args, hear, { folder = root, environment = process.env } = {}) {
  return new Promise((resolve) => {
    const child = spawn(command, args, { cwd: folder, env: environment, shell: isWindows });
    child.stdout.on("data", hear);
    child.stderr.on("data", hear);
    child.on("error", (error) => {
      hear(String(error));
      resolve(undefined);
    });
    child.on("close", resolve);
  });
}

/** Runs programs at the same time, and shows the output of each when all of them have ended. */
export async function runTogether(...commands) {
  const ended = await Promise.all(
    commands.map(async ([command, ...args]) => {
      let output = "";
      const status = await listenTo(command, args, (chunk) => {
        output += chunk;
      });
      return { output, status };
    }),
  );
  for (const { output } of ended) console.log(output);
  const failed = commands.find((_, at) => ended[at].status !== 0);
  if (failed !== undefined) throw new Stop(`${failed.join(" ")} failed; its words are above`);
}

/**
 * Runs a program with its output in a log, here or in another folder. If it fails, one line says what
 * could not be done, why as far as the program told, and what to do.
 */
export async function runQuietly({ task, advice, ...place }, command, ...args) {
  mkdirSync(join(root, "target"), { recursive: true });
  const logFile = join("target", `${task.replaceAll(" ", "-")}.log`);
  const log = createWriteStream(join(root, logFile));
  let output = "";
  const hear = (chunk) => {
    log.write(chunk);
    output = (output + chunk).slice(-longestReason);
  };
  const status = await listenTo(command, args, hear, place);
  log.end();
  if (status === 0) return;
  const reason = output.split("\n").find((line) => /\berror\b|failed|could not/i.test(line)) ?? "";
  throw new Stop(
    `could not ${task} (${reason.trim()}): ${advice}; all that was said is in ${logFile}`,
  );
}

/** Runs a task; a Stop becomes one line and exit code 1. */
export async function main(task) {
  try {
    await task();
  } catch (error) {
    if (!(error instanceof Stop)) throw error;
    console.error(`quatlas: ${error.message}`);
    process.exit(1);
  }
}

export function exists(...path) {
  return existsSync(join(root, ...path));
}
