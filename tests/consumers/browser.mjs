// A page of a project in Chromium: what its title becomes.
import { createReadStream, existsSync, statSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join } from "node:path";
import { chromium } from "@playwright/test";
import { setUpChromium } from "../../www/tasks/engines.mjs";

const TYPES = {
  ".css": "text/css",
  ".html": "text/html",
  ".js": "text/javascript",
  ".json": "application/json",
  ".mjs": "text/javascript",
  ".wasm": "application/wasm",
};

/** Longer than any page here takes. */
const patienceMs = 15_000;

/**
 * Chromium. `titleOf` opens an address and waits for a title;
 * `served` does so with a file of a folder that is served, with the policy that is named.
 */
export async function startBrowser() {
  const executablePath = await setUpChromium();
  const browser = await chromium.launch({
    ...(executablePath ? { executablePath } : {}),
    args: ["--no-sandbox"],
  });
  const titleOf = async (address) => {
    const page = await browser.newPage();
    try {
      await page.goto(address);
      await page.waitForFunction(() => document.title !== "", undefined, { timeout: patienceMs });
      return await page.title();
    } finally {
      await page.close();
    }
  };
  const served = async (folder, file, policy) => {
    const server = await serve(folder, policy);
    try {
      return await titleOf(`http://127.0.0.1:${server.address().port}/${file}`);
    } finally {
      server.close();
      server.closeAllConnections();
    }
  };
  return { titleOf, served, close: () => browser.close() };
}

function serve(folder, policy) {
  const server = createServer((request, response) => {
    const { pathname } = new URL(request.url, "http://127.0.0.1");
    const file = join(folder, decodeURIComponent(pathname));
    if (!existsSync(file) || !statSync(file).isFile()) {
      response.writeHead(404).end();
      return;
    }
    // As the hosts of packages do: what is no script by its type is not run.
    response.setHeader("X-Content-Type-Options", "nosniff");
    response.setHeader("Content-Type", TYPES[extname(file)] ?? "application/octet-stream");
    if (policy !== undefined) response.setHeader("Content-Security-Policy", policy);
    createReadStream(file).pipe(response);
  });
  return new Promise((resolve) => server.listen(0, "127.0.0.1", () => resolve(server)));
}
