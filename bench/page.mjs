// How quick the built page is in a real browser: medians of 30 runs, and the bytes of every part.
// `npm test` or `npm start` builds it first; then `node bench/page.mjs`.

import { preview } from "vite";
import { brotliOf, partsOfPage } from "../www/tasks/page_parts.mjs";
import { root } from "../www/tasks/shell.mjs";
import { launchChromium } from "./browsers.mjs";

const runs = 30;
const server = await preview({
  configFile: `${root}/www/vite.config.ts`,
  logLevel: "warn",
  preview: { port: 4191 },
});
const [address] = server.resolvedUrls.local;
const browser = await launchChromium();

/** Each view with what is typed into: a field, and what of the page changes then. */
const typed = [
  { view: "read", field: ".ask textarea", text: "0.92 + 0.3k" },
  { view: "compose", field: ".ask textarea", text: "0.92 + 0.3k" },
  { view: "translate", field: ".ask textarea", text: "0.1 -0.2 0.4 0.8" },
  { view: "identify", field: ".observation textarea", text: "-1 0 0 0" },
];

/** Before the page: notes the first result, and what shifts by itself. */
function watch() {
  globalThis.shift = 0;
  new PerformanceObserver((list) => {
    for (const { value, hadRecentInput } of list.getEntries()) {
      if (!hadRecentInput) globalThis.shift += value;
    }
  }).observe({ type: "layout-shift", buffered: true });
  new MutationObserver((_, observer) => {
    if (document.querySelector("td") === null) return;
    globalThis.firstResultMs = performance.now();
    observer.disconnect();
  }).observe(document, { childList: true, subtree: true });
}

async function open(view) {
  const context = await browser.newContext();
  const page = await context.newPage();
  await page.addInitScript(watch);
  await page.goto(`${address}#${view}`, { waitUntil: "networkidle" });
  await page.waitForSelector(".result td");
  return page;
}

/** Milliseconds from the start of the navigation: to the first matrix, to the first paint with content. */
async function start() {
  const page = await open("read");
  const times = await page.evaluate(() => ({
    result: globalThis.firstResultMs,
    paint: performance.getEntriesByName("first-contentful-paint")[0]?.startTime,
  }));
  await page.context().close();
  return times;
}

/**
 * Milliseconds of every key, from its input event: until the document is changed, which is all script,
 * and until the second frame, when the numbers are on the screen.
 */
async function keystrokes({ view, field, text }) {
  const page = await open(view);
  const place = page.locator(field).first();
  // By keys: what a script fills in counts as a shift by itself.
  await place.press("ControlOrMeta+a");
  await place.pressSequentially(text);
  await page.evaluate(watchKeys);
  for (let run = 0; run < runs; run += 2) {
    for (const key of ["5", "Backspace"]) {
      await place.press(key);
      await page.waitForFunction(() => globalThis.keys.at(-1)?.painted !== undefined);
    }
  }
  const measured = await page.evaluate(() => ({ keys: globalThis.keys, shift: globalThis.shift }));
  await page.context().close();
  return measured;
}

function watchKeys() {
  globalThis.keys = [];
  const key = {};
  // The window hears the event first, then the field, whose microtasks render, then the window again.
  addEventListener("input", () => Object.assign(key, { began: performance.now() }), true);
  addEventListener("input", () => {
    const { began } = key;
    const measured = { script: performance.now() - began };
    globalThis.keys.push(measured);
    const painted = () => Object.assign(measured, { painted: performance.now() - began });
    requestAnimationFrame(() => requestAnimationFrame(painted));
  });
}

/**
 * Milliseconds of script of every move of a drag, until picture and numbers are in the document: of the
 * body, which writes the quaternion, and beside it, which looks round. A frame of 60 in a second has 16.7.
 */
async function drags(part) {
  const page = await open("read");
  const stage = page.locator(".stage");
  await stage.waitFor();
  const { x, y, width, height } = await stage.boundingBox();
  const [left, top] = part === "body" ? [width / 2 + 4, height / 2 + 10] : [20, 20];
  await page.mouse.move(x + left, y + top);
  await page.mouse.down();
  await page.evaluate(() => {
    globalThis.moves = [];
    let began = 0;
    const start = () => {
      began = performance.now();
    };
    addEventListener("pointermove", start, true);
    addEventListener("pointermove", () => globalThis.moves.push(performance.now() - began));
  });
  for (let run = 1; run <= runs; run += 1) {
    await page.mouse.move(x + left + 3 * run, y + top + 2 * run);
    await page.evaluate(() => new Promise((painted) => requestAnimationFrame(painted)));
  }
  await page.mouse.up();
  const moves = await page.evaluate(() => globalThis.moves);
  await page.context().close();
  return moves;
}

/** Median, least and most. */
function spread(numbers) {
  const sorted = numbers.toSorted((a, b) => a - b);
  const at = (part) => Number(sorted[Math.floor(part * (sorted.length - 1))].toFixed(1));
  return { median: at(0.5), least: at(0), most: at(1), runs: sorted.length };
}

const times = {};
await start();
const starts = [];
for (let run = 0; run < runs; run += 1) starts.push(await start());
times["navigation to first result"] = spread(starts.map(({ result }) => result));
times["navigation to first paint with content"] = spread(starts.map(({ paint }) => paint));
const shifts = {};
for (const what of typed) {
  const { keys, shift } = await keystrokes(what);
  times[`${what.view}: key to changed document`] = spread(keys.map(({ script }) => script));
  times[`${what.view}: key to painted`] = spread(keys.map(({ painted }) => painted));
  shifts[what.view] = { "cumulative layout shift": Number(shift.toFixed(4)) };
}
for (const part of ["body", "view"]) {
  times[`read: move of a drag of the ${part}`] = spread(await drags(part));
}
await browser.close();
await server.close();

console.log("milliseconds");
console.table(times);
console.log("from loading through typing");
console.table(shifts);
/** What each kind of parts is for; nothing of `lazy` and `fonts` is needed until typing answers. */
const kinds = { first: "to live", lazy: "later", fonts: "fonts" };
for (const [kind, parts] of Object.entries(partsOfPage())) {
  const sizes = parts.map((part) => [part.name, part.bytes, part.gzip, brotliOf(part)]);
  const total = [1, 2, 3].map((column) => sizes.reduce((sum, size) => sum + size[column], 0));
  const rows = [...sizes, ["all", ...total]];
  console.log(`bytes ${kinds[kind]}`);
  console.table(
    Object.fromEntries(rows.map(([name, bytes, gzip, brotli]) => [name, { bytes, gzip, brotli }])),
  );
}
