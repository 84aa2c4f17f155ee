// How quick the built page is in a real browser: median and range of 30 runs.
// `npm test` or `npm start` builds it first; then `node benches/page.mjs`.

import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { gzipSync } from "node:zlib";
import { chromium } from "@playwright/test";
import { preview } from "vite";
import { setUpBrowser } from "../www/tasks/setup.mjs";
import { root } from "../www/tasks/shell.mjs";

const runs = 30;
const configFile = join(root, "www", "vite.config.ts");
const server = await preview({ configFile, logLevel: "warn", preview: { port: 4191 } });
const [address] = server.resolvedUrls.local;
const executablePath = await setUpBrowser();
const browser = await chromium.launch({
  ...(executablePath ? { executablePath } : {}),
  args: ["--no-sandbox", "--disable-background-networking"],
});

/** Milliseconds from the start of the navigation to the first matrix on the page. */
async function firstResult() {
  const context = await browser.newContext();
  const page = await context.newPage();
  await page.addInitScript(() => {
    new MutationObserver((_, observer) => {
      if (document.querySelector("td") === null) return;
      globalThis.firstResultMs = performance.now();
      observer.disconnect();
    }).observe(document, { childList: true, subtree: true });
  });
  await page.goto(address);
  await page.waitForSelector("td");
  const elapsed = await page.evaluate(() => globalThis.firstResultMs);
  await context.close();
  return elapsed;
}

/** Milliseconds from the key event to the changed matrix in the document. */
async function keystrokes() {
  const page = await browser.newPage();
  await page.goto(address);
  const field = page.getByRole("textbox", { name: "quaternion q" });
  await field.fill("0.92 + 0.3");
  await field.press("End");
  await page.evaluate(() => {
    globalThis.elapsed = [];
    addEventListener("keydown", (event) => {
      globalThis.pressedAt = event.timeStamp;
    });
    new MutationObserver(() => {
      if (globalThis.pressedAt === undefined) return;
      globalThis.elapsed.push(performance.now() - globalThis.pressedAt);
      globalThis.pressedAt = undefined;
    }).observe(document.querySelector(".result"), {
      characterData: true,
      childList: true,
      subtree: true,
    });
  });
  await field.pressSequentially("k");
  await page.keyboard.press("ArrowLeft");
  for (let run = 0; run < runs; run += 2) {
    await page.keyboard.press("8");
    await page.keyboard.press("Backspace");
  }
  const elapsed = await page.evaluate(() => globalThis.elapsed);
  await page.close();
  return elapsed.slice(-runs);
}

function report(name, milliseconds) {
  const sorted = milliseconds.toSorted((a, b) => a - b);
  const at = (part) => sorted[Math.floor(part * (sorted.length - 1))].toFixed(1);
  console.log(`${name}: median ${at(0.5)} ms, ${at(0)} to ${at(1)} (${sorted.length} runs)`);
}

await firstResult();
const first = [];
for (let run = 0; run < runs; run += 1) first.push(await firstResult());
report("navigation to first result", first);
report("key to changed numbers", await keystrokes());
await browser.close();
await server.close();

const folder = join(root, "dist", "page");
const names = [
  "index.html",
  ...readdirSync(join(folder, "assets")).map((name) => join("assets", name)),
];
let total = [0, 0];
for (const name of names) {
  const bytes = readFileSync(join(folder, name));
  const sizes = [
    bytes.length,
    /woff2$/.test(name) ? bytes.length : gzipSync(bytes, { level: 9 }).length,
  ];
  total = total.map((sum, at) => sum + sizes[at]);
  console.log(`${name}: ${sizes[0]} bytes, ${sizes[1]} compressed`);
}
console.log(`all: ${total[0]} bytes, ${total[1]} compressed`);
