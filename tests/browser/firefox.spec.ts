// The opening page and the width of every number in Firefox, as people have it: over WebDriver BiDi,
// because Playwright drives a Firefox of its own making only.
import { test as base, expect } from "@playwright/test";
import { launch, type Page } from "puppeteer-core";
import { addresses, cutNumbers, isShown } from "./support/whole_numbers.ts";

const executablePath = process.env["QUATLAS_FIREFOX"];

const test = base.extend<{ firefoxPage: Page }, { firefox: Awaited<ReturnType<typeof launch>> }>({
  firefox: [
    // biome-ignore lint/correctness/noEmptyPattern: Playwright reads the names of the fixtures.
    async ({}, use) => {
      if (!executablePath) throw new Error("QUATLAS_FIREFOX has no path of a Firefox");
      const firefox = await launch({
        browser: "firefox",
        executablePath,
        // Every file comes from the server, and nothing is looked up.
        extraPrefsFirefox: { "dom.serviceWorkers.enabled": false },
      });
      await use(firefox);
      await firefox.close();
    },
    { scope: "worker" },
  ],
  firefoxPage: async ({ firefox }, use) => {
    const page = await firefox.newPage();
    const errors: unknown[] = [];
    page.on("console", (message) => {
      if (message.type() === "error") errors.push(message.text());
    });
    page.on("pageerror", (error) => errors.push(error));
    await use(page);
    await page.close();
    expect(errors, "console errors").toEqual([]);
  },
});
// One browser, which takes some seconds to start on a busy machine.
test.describe.configure({ mode: "default", timeout: 60_000 });

async function open(page: Page, url: string) {
  await page.goto(url);
  await page.waitForFunction(isShown);
}

test("Firefox opens on 45° about z with every output filled", async ({ firefoxPage, baseURL }) => {
  await firefoxPage.setViewport({ width: 1280, height: 800 });
  await open(firefoxPage, `${baseURL}`);
  const valuesIn = (name: string) =>
    firefoxPage.$$eval(`table[aria-label="${name}"] input`, (fields) =>
      fields.map(({ value }) => value.trim()),
    );
  const [cosine, sine, minusSine] = ["0.707107", "0.707107", "−0.707107"];
  expect(await valuesIn("R(q)")).toEqual([
    cosine,
    minusSine,
    "0",
    sine,
    cosine,
    "0",
    "0",
    "0",
    "1",
  ]);
  expect(await valuesIn("C(q)")).toEqual([
    cosine,
    sine,
    "0",
    minusSine,
    cosine,
    "0",
    "0",
    "0",
    "1",
  ]);
  // A number is typed where it stands, and all others follow.
  const [first] = await firefoxPage.$$('table[aria-label="R(q)"] input');
  await first?.focus();
  await firefoxPage.keyboard.type("1");
  await firefoxPage.waitForFunction(() => document.querySelector("textarea")?.value[1] === "1");
});

for (const address of addresses) {
  test(`Firefox shows every number whole: ${address}`, async ({ firefoxPage, baseURL }) => {
    await firefoxPage.setViewport({ width: 1280, height: 800 });
    await open(firefoxPage, `${baseURL}#${encodeURI(address)}`);
    expect(await firefoxPage.evaluate(cutNumbers), "1280 px").toEqual([]);
    await firefoxPage.setViewport({ width: 320, height: 800 });
    expect(await firefoxPage.evaluate(cutNumbers), "320 px").toEqual([]);
  });
}
