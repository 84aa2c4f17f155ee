// A built page on a server of its own, in a sub-folder, that can publish a new version and go away.
import {
  cpSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  renameSync,
  rmSync,
  writeFileSync,
} from "node:fs";
import { createServer } from "node:http";
import type { AddressInfo } from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { mediaTypeOf } from "../../../www/tasks/page_parts.mjs";
import { writeServiceWorker } from "../../../www/tasks/precache.ts";

const built = join(import.meta.dirname, "../../../dist/page");
const subFolder = "/tools/rotations/";

export type Site = Awaited<ReturnType<typeof openSite>>;

export async function openSite() {
  const folder = mkdtempSync(join(tmpdir(), "quatlas-site-"));
  cpSync(built, folder, { recursive: true });
  const missing: string[] = [];
  const server = createServer(({ url = "" }, response) => {
    const { pathname } = new URL(url, "http://localhost");
    const path = pathname.slice(subFolder.length) || "index.html";
    const content = pathname.startsWith(subFolder) ? read(join(folder, path)) : undefined;
    if (content === undefined) missing.push(pathname);
    response.writeHead(content ? 200 : 404, { "Content-Type": mediaTypeOf(path) });
    response.end(content);
  });
  await new Promise<void>((listening) => server.listen(0, "localhost", listening));
  const { port } = server.address() as AddressInfo;
  return {
    url: `http://localhost:${port}${subFolder}`,
    folder,
    /** What was asked for and is not there. */
    missing,
    /** From now on nothing is answered. */
    goAway: () => {
      server.close();
      server.closeAllConnections();
    },
    remove: () => rmSync(folder, { recursive: true }),
    publish: (description: string) => publish(folder, description),
  };
}

function read(path: string): Buffer | undefined {
  try {
    return readFileSync(path);
  } catch {
    return undefined;
  }
}

/** A new version: another description, and every script of another name; those of the old names are gone. */
function publish(folder: string, description: string) {
  const assets = join(folder, "assets");
  const scripts = readdirSync(assets).filter((name) => name.endsWith(".js"));
  const renamed = (name: string) => name.replace(/\.js$/, "2.js");
  const rewrite = (path: string) => {
    let text = readFileSync(path, "utf8");
    for (const script of scripts) text = text.replaceAll(script, renamed(script));
    writeFileSync(path, text.replace(/(name="description"\s+content=")[^"]*/, `$1${description}`));
  };
  rewrite(join(folder, "index.html"));
  for (const script of scripts) {
    rewrite(join(assets, script));
    renameSync(join(assets, script), join(assets, renamed(script)));
  }
  writeServiceWorker(folder);
}
