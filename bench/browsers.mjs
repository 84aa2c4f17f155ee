// The browsers that a page is measured in.
import { setTimeout as pause } from "node:timers/promises";
import { chromium } from "@playwright/test";
import { runnerImport } from "vite";
import { setUpChromium } from "../www/tasks/engines.mjs";
import { root } from "../www/tasks/shell.mjs";
import { watch } from "./watch.mjs";

const viewport = { width: 1280, height: 800 };

/** Chromium, which asks for nothing by itself. */
export async function launchChromium() {
  const executablePath = await setUpChromium();
  return chromium.launch({
    ...(executablePath ? { executablePath } : {}),
    args: ["--no-sandbox", "--disable-background-networking"],
  });
}

/**
 * Starts an engine by its name. `load` opens an address in a page that nothing is left in and tells what
 * was seen there. One that `throttles` slows its line and its processor itself, counts bytes, and takes the
 * script that watches; for another the server has to.
 */
export const startEngine = (name) => (name === "Chromium" ? startChromium() : startOther(name));

async function startChromium() {
  const browser = await launchChromium();
  const load = async (address, { line, watched }) => {
    const context = await browser.newContext({ viewport });
    const page = await context.newPage();
    await page.addInitScript(watch, watched);
    const received = await throttle(await context.newCDPSession(page), line);
    await page.goto(address);
    await page.evaluate(tell);
    // What follows by itself may move something too.
    await page.evaluate(idle);
    while (await isReceiving(received)) {}
    const { startMs, ...seen } = await page.evaluate(tell);
    await context.close();
    const bytesUntil = (endMs) =>
      received.reduce((sum, { atMs, bytes }) => (atMs - startMs <= endMs ? sum + bytes : sum), 0);
    return {
      ...seen,
      matrixBytes: bytesUntil(seen.matrixMs),
      liveBytes: bytesUntil(seen.liveMs),
      allBytes: bytesUntil(Number.POSITIVE_INFINITY),
    };
  };
  return { throttles: true, load, close: () => browser.close() };
}

/** Makes the browser slow, and notes what arrives, at times of the clock on the wall. */
async function throttle(session, { network, processor }) {
  await session.send("Network.enable");
  await session.send("Network.setCacheDisabled", { cacheDisabled: true });
  if (network !== undefined) {
    await session.send("Network.emulateNetworkConditions", {
      offline: false,
      latency: network.latencyMs,
      downloadThroughput: network.downBitsPerSecond / 8,
      uploadThroughput: network.upBitsPerSecond / 8,
    });
  }
  if (processor !== undefined) {
    await session.send("Emulation.setCPUThrottlingRate", { rate: processor.timesSlower });
  }
  const received = [];
  /** The bytes so far of each request. */
  const counted = new Map();
  let clockMs;
  session.on("Network.requestWillBeSent", ({ timestamp, wallTime }) => {
    clockMs ??= 1000 * (wallTime - timestamp);
  });
  const count = (requestId, timestamp, bytes) => {
    received.push({ atMs: clockMs + 1000 * timestamp, bytes });
    counted.set(requestId, (counted.get(requestId) ?? 0) + bytes);
  };
  session.on("Network.dataReceived", ({ requestId, timestamp, encodedDataLength }) => {
    count(requestId, timestamp, encodedDataLength);
  });
  // The headers, and the page itself, are told only at the end.
  session.on("Network.loadingFinished", ({ requestId, timestamp, encodedDataLength }) => {
    count(requestId, timestamp, encodedDataLength - (counted.get(requestId) ?? 0));
  });
  return received;
}

/** Whether something arrives in half a second. */
async function isReceiving(received) {
  const { length } = received;
  await pause(500);
  return received.length > length;
}

/** To be run in the page. */
const idle = () => new Promise((resolve) => requestIdleCallback(() => resolve()));

/** To be run in the page. */
const tell = async () => ({ ...(await globalThis.seen), startMs: performance.timeOrigin });

/** As the tests of every engine drive it. */
async function startOther(name) {
  const file = `${root}/tests/browser/engines/${name.toLowerCase()}.ts`;
  const { module } = await runnerImport(file, { configFile: false });
  const engine = await module[`start${name}`]();
  const load = async (address, { watched }) => {
    await engine.open(address, viewport.width);
    const endMs = performance.now() + watched.longestMs;
    // The driver of WebKit may take the end of the empty page before it for that of the page.
    while (!(await engine.evaluate(isThere)) && performance.now() < endMs) await pause(20);
    return engine.evaluate(tell);
  };
  return { throttles: false, load, close: () => engine.close() };
}

/** To be run in the page. */
const isThere = () => globalThis.seen !== undefined;
