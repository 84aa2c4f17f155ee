// A folder with the package in its node_modules, unpacked from what `npm pack` makes, and every small project.
import { execFile, execFileSync } from "node:child_process";
import { cpSync, mkdirSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { promisify } from "node:util";

export const root = fileURLToPath(new URL("../..", import.meta.url));
const projects = fileURLToPath(new URL("projects", import.meta.url));
const shell = process.platform === "win32";

/** The packed package, in a folder of its own. */
export function pack() {
  const folder = mkdtempSync(join(tmpdir(), "quatlas-packed-"));
  // --ignore-scripts: it has just been built, and a package must install without scripts.
  const [{ filename }] = JSON.parse(
    execFileSync("npm", ["pack", "--json", "--ignore-scripts", "--pack-destination", folder], {
      cwd: root,
      encoding: "utf8",
      shell,
    }),
  );
  return { tarball: join(folder, filename), remove: () => rmSync(folder, { recursive: true }) };
}

/** The project, with the package and nothing else installed; `remove` takes it away. */
export function unpackedProject({ tarball }) {
  const project = emptyProject();
  const installed = project.path("node_modules", "quatlas");
  mkdirSync(installed, { recursive: true });
  execFileSync("tar", ["-xzf", tarball, "-C", installed, "--strip-components=1"]);
  return project;
}

/** The project, with the package and others installed from the registry. */
export async function installedProject({ tarball }, packages) {
  const project = emptyProject();
  await project.run("npm", "init", "--yes");
  const quiet = ["--no-audit", "--no-fund", "--loglevel=error"];
  await project.run("npm", "install", ...quiet, tarball, ...packages);
  return project;
}

function emptyProject() {
  const folder = mkdtempSync(join(tmpdir(), "quatlas-consumer-"));
  cpSync(projects, folder, { recursive: true });
  const path = (...parts) => join(folder, ...parts);
  return {
    folder,
    path,
    run: (command, ...args) => output(folder, command, args),
    /** What a program of an installed package prints. */
    tool: (name, ...args) => output(folder, path("node_modules", ".bin", name), args),
    /** What this Node prints for a script. */
    node: (...args) => output(folder, process.execPath, args),
    remove: () => rmSync(folder, { recursive: true, force: true, maxRetries: 3 }),
  };
}

/** What a program prints; if it fails, an error with all that it said. */
export async function output(folder, command, args) {
  try {
    const { stdout } = await promisify(execFile)(command, args, {
      cwd: folder,
      shell,
      maxBuffer: 2 ** 26,
    });
    return stdout.trim();
  } catch (error) {
    throw new Error(`${error.stdout}\n${error.stderr}`.trim() || error.message);
  }
}
