// Puts the service worker beside a built page, with the list of the files that it keeps.
import { createHash } from "node:crypto";
import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import { join, relative, sep } from "node:path";
import type { Plugin } from "vite";

const name = "service_worker.js";
const source = join(import.meta.dirname, "..", name);

/** As policies and integrity name it. */
export const sha256 = (content: string | Buffer) =>
  createHash("sha256").update(content).digest("base64");

/** Every file below the folder, by its path with forward slashes, in order. */
function filesBelow(folder: string): string[] {
  return readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => relative(folder, join(entry.parentPath, entry.name)).replaceAll(sep, "/"))
    .sort();
}

export function writeServiceWorker(folder: string) {
  const files = Object.fromEntries(
    filesBelow(folder)
      .filter((path) => path !== name && !path.endsWith(".map"))
      .map((path) => [
        // Some hosts redirect index.html to its folder, and a redirect cannot be kept.
        path === "index.html" ? "" : path,
        `sha256-${sha256(readFileSync(join(folder, path)))}`,
      ]),
  );
  const worker = readFileSync(source, "utf8");
  const list = JSON.stringify(files, null, 1);
  const version = sha256(list + worker).slice(0, 12);
  writeFileSync(
    join(folder, name),
    `const version = ${JSON.stringify(version)};\nconst files = ${list};\n\n${worker}`,
  );
}

export function precache(): Plugin {
  return {
    name: "quatlas:precache",
    apply: "build",
    writeBundle: {
      order: "post",
      sequential: true,
      handler({ dir }) {
        if (dir !== undefined) writeServiceWorker(dir);
      },
    },
  };
}
