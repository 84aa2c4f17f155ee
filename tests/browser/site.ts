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
import { extname, join } from "node:path";
import { writeServiceWorker } from "../../www/tasks/precache.ts";

const built = join(import.meta.dirname, "../../dist/page");
const subFolder = "/tools/rotations/";

const types: Record<string, string> = {
  ".html": "text/html",
  ".js": "text/javascript",
  ".css": "text/css",
  ".wasm": "application/wasm",
  ".woff2": "font/woff2",
  ".svg": "image/svg+xml",
  ".png": "image/png",
  ".webmanifest": "application/manifest+json",
};

export type Site = Awaited<ReturnType<typeof openSite>>;

export async function openSite() {
  const folder = mkdtempSync(join(tmpdir(), "quatlas-site-"));
  cpSync(built, folder, { recursive: true });
  const server = createServer(({ url = "" }, response) => {
    const { pathname } = new URL(url, "http://localhost");
    const path = pathname.slice(subFolder.length) || "index.html";
    const content = pathname.startsWith(subFolder) ? read(join(folder, path)) : undefined;
    response.writeHead(content ? 200 : 404, { "Content-Type": types[extname(path)] ?? "" });
    response.end(content);
  });
  await new Promise<void>((listening) => server.listen(0, "localhost", listening));
  const { port } = server.address() as AddressInfo;
  return {
    url: `http://localhost:${port}${subFolder}`,
    folder,
    /** From now on nothing is answered. */
    goAway: () => {
      server.close();
      server.closeAllConnections();
    },
    remove: () => rmSync(folder, { recursive: true }),
    publish: (title: string) => publish(folder, title),
  };
}

function read(path: string): Buffer | undefined {
  try {
    return readFileSync(path);
  } catch {
    return undefined;
  }
}

/** A new version: another title, and a first script of another name; the old one is gone. */
function publish(folder: string, title: string) {
  const assets = join(folder, "assets");
  const page = readFileSync(join(folder, "index.html"), "utf8");
  const [, script = ""] = page.match(/assets\/(index-[\w-]+\.js)/) ?? [];
  const renamed = `index-${title.replaceAll(" ", "-")}.js`;
  renameSync(join(assets, script), join(assets, renamed));
  const texts = readdirSync(assets).filter((name) => name.endsWith(".js"));
  for (const path of [...texts.map((name) => join(assets, name)), join(folder, "index.html")]) {
    const text = readFileSync(path, "utf8").replaceAll(script, renamed);
    writeFileSync(path, text.replace(/<title>.*<\/title>/, `<title>${title}</title>`));
  }
  writeServiceWorker(folder);
}
