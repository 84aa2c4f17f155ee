// A test of one engine: what goes wrong in the page, or on the way to it, fails it.
import { test as base, expect, type LaunchOptions } from "@playwright/test";
import { startChromium } from "../engines/chromium.ts";
import type { Engine, EngineName, Point } from "../engines/engine.ts";
import { startFirefox } from "../engines/firefox.ts";
import { startWebKit } from "../engines/webkit.ts";
import type { Site } from "./site.ts";
import { openWatchedSite, takeFaults } from "./watched_site.ts";
import { isShown } from "./whole_numbers.ts";

const start: Record<EngineName, (options: LaunchOptions) => Promise<Engine>> = {
  chromium: startChromium,
  firefox: () => startFirefox(),
  webkit: startWebKit,
};

export const test = base.extend<
  { site: Site; engine: Engine },
  { engineName: EngineName; started: Engine }
>({
  engineName: ["chromium", { option: true, scope: "worker" }],
  started: [
    async ({ engineName, launchOptions }, use) => {
      const engine = await start[engineName](launchOptions);
      await use(engine);
      await engine.close();
    },
    { scope: "worker", timeout: 60_000 },
  ],
  // biome-ignore lint/correctness/noEmptyPattern: Playwright reads the names of the fixtures.
  site: async ({}, use) => {
    const site = await openWatchedSite();
    await use(site);
    site.goAway();
    site.remove();
  },
  engine: async ({ started, site }, use) => {
    await use(started);
    expect(await started.evaluate(takeFaults), "what went wrong in the page").toEqual([]);
    expect(started.consoleErrors.splice(0), "console errors").toEqual([]);
    expect(site.missing, "what the page asked for in vain").toEqual([]);
  },
});

/** Beside the other work of a busy machine. */
const aWhile = { timeout: 30_000 };

/** Waits for what the page shows. */
export const shown = <Seen>(engine: Engine, look: () => Seen | Promise<Seen>) =>
  expect.poll(() => engine.evaluate(look), aWhile);

/** Opens an address of the page and waits until the view is there. */
export async function openView(engine: Engine, address: string, widthPx: number) {
  await engine.open(address, widthPx);
  await shown(engine, isShown).toBe(true);
}

/** Clicks the middle of the first element of a selector. */
export async function click(engine: Engine, selector: string) {
  await engine.drag(await engine.evaluate(middleOf, selector));
}

/** The place of an element that is brought into sight. To be run in the page. */
export function middleOf(selector: string): Point {
  const element = document.querySelector(selector);
  if (element === null) throw new Error(`there is no ${selector}`);
  element.scrollIntoView({ block: "center" });
  const { x, y, width, height } = element.getBoundingClientRect();
  return { x: x + width / 2, y: y + height / 2 };
}

/** The text in the field of the quaternion. To be run in the page. */
export const quaternion = () =>
  document.querySelector<HTMLTextAreaElement>("textarea[name=quaternion]")?.value;

/** The matrices by name, each with its cells row by row. To be run in the page. */
export function matrices(): Record<string, string> {
  const textOf = (cell: Element) => cell.querySelector("input")?.value ?? cell.textContent ?? "";
  return Object.fromEntries(
    [...document.querySelectorAll("main :is(table, [role=grid])")].map((matrix) => [
      matrix.getAttribute("aria-label"),
      [...matrix.querySelectorAll("td")].map((cell) => textOf(cell).trim()).join(" "),
    ]),
  );
}

/** What can be read. To be run in the page. */
export const words = () => document.body.innerText;

export { expect };
