// The page without a network, and its next version, in a browser that keeps service workers.
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "@playwright/test";
import {
  test as base,
  expect,
  matrix,
  numbersOf,
  part,
  quaternionField,
  tab,
  violationsOf,
} from "./support/page.ts";
import { openSite, type Site } from "./support/site.ts";

const test = base.extend<{ site: Site }>({
  // biome-ignore lint/correctness/noEmptyPattern: Playwright reads the names of the fixtures.
  site: async ({}, use) => {
    const site = await openSite();
    await use(site);
    site.goAway();
    site.remove();
  },
  baseURL: async ({ site }, use) => use(site.url),
});
test.use({ serviceWorkers: "allow" });
// A browser looks for a new version some seconds after a visit.
test.describe.configure({ timeout: 90_000 });
const aWhile = { timeout: 20_000 };

/** Opens the page and waits until it is kept for use without a network. */
async function visit(page: Page) {
  await page.goto("./");
  await expect(matrix(page, "R(q)")).toBeVisible();
  await expect
    .poll(() => page.evaluate(() => navigator.serviceWorker.controller?.state), aWhile)
    .toBe("activated");
}

const newVersion = (page: Page) => page.getByText("A new version is ready.");

const reloadButton = (page: Page) => page.getByRole("button", { name: "Reload" });

/** What tells the versions apart. */
const description = (page: Page) => page.locator("meta[name=description]");

/** A worker at work is not replaced, and one that is watched, as in these tests, never rests. */
async function reloadIntoNewVersion(page: Page, written: string) {
  const session = await page.context().newCDPSession(page);
  const active = new Promise<string>((found) => {
    session.on("ServiceWorker.workerVersionUpdated", ({ versions }) => {
      const version = versions.find(({ status }) => status === "activated");
      if (version) found(version.versionId);
    });
  });
  await session.send("ServiceWorker.enable");
  const versionId = await active;
  await reloadButton(page).click();
  const rest = () => session.send("ServiceWorker.stopWorker", { versionId }).catch(() => undefined);
  await expect
    .poll(
      () =>
        rest()
          .then(() => description(page).getAttribute("content"))
          .catch(() => ""),
      aWhile,
    )
    .toBe(written);
  await session.detach();
}

test("after one visit the whole page works without a network", async ({ page, context, site }) => {
  await visit(page);
  site.goAway();
  await page.reload();
  await quaternionField(page).fill("1/2 + i/2 + j/2 + k/2");
  await expect.poll(() => numbersOf(matrix(page, "R(q)"))).toEqual([0, 0, 1, 1, 0, 0, 0, 1, 0]);
  for (const link of [
    tab(page, "Compose"),
    tab(page, "Libraries"),
    part(page, "Identify"),
    part(page, "All libraries"),
    tab(page, "Read"),
  ]) {
    await link.click();
    await expect(link).toHaveAttribute("aria-current", "page");
    await expect(page.locator("main").locator("input, textarea").first()).toBeVisible();
  }
  // However it is reached; and every file of the build is there.
  for (const address of ["./index.html", "./?from=home#compose"]) {
    const another = await context.newPage();
    await another.goto(address);
    await expect(another.locator("table").first()).toBeVisible();
    await another.close();
  }
  const worker = readFileSync(join(site.folder, "service_worker.js"), "utf8");
  const [, list = ""] = worker.match(/const files = (\{.*?\});/s) ?? [];
  const paths = Object.keys(JSON.parse(list));
  expect(paths).toContain("manifest.webmanifest");
  expect(paths).toContain("licences.txt");
  const missing = await page.evaluate(async (paths) => {
    const answers = await Promise.all(paths.map((path) => fetch(path)));
    return answers.filter(({ ok }) => !ok).map(({ url }) => url);
  }, paths);
  expect(missing).toEqual([]);
});

test("a new version waits until it is asked for, and then keeps what was typed", async ({
  page,
  site,
}) => {
  await visit(page);
  const [, first = ""] = (await page.content()).match(/assets\/(index-[\w-]+\.js)/) ?? [];
  await page.evaluate(async (scope) => {
    await caches.open("another page");
    await caches.open(`quatlas ${scope}deeper/ 1`);
  }, site.url);
  site.publish("Version two");
  await page.reload();
  await expect(newVersion(page)).toBeVisible(aWhile);
  await expect(page).toHaveTitle(/ · quatlas$/);
  expect(await violationsOf(page)).toEqual([]);
  const before = await page.evaluate(() => caches.keys());

  await page.getByRole("button", { name: "Later" }).click();
  await expect(newVersion(page)).toBeHidden();
  await page.reload();
  await expect(page).toHaveTitle(/ · quatlas$/);
  await expect(newVersion(page)).toBeVisible(aWhile);

  await quaternionField(page).fill("0 0 0.6 0.8");
  await reloadIntoNewVersion(page, "Version two");
  await expect(quaternionField(page)).toHaveValue("0 0 0.6 0.8");
  await expect(newVersion(page)).toBeHidden();
  // The files of the first version are gone, those of other pages are not.
  const after = await page.evaluate(() => caches.keys());
  expect(before).toHaveLength(4);
  expect(after).toHaveLength(3);
  expect(after).toEqual(expect.arrayContaining(["another page", `quatlas ${site.url}deeper/ 1`]));
  expect(await page.evaluate((path) => caches.match(path).then(Boolean), `assets/${first}`)).toBe(
    false,
  );
  site.goAway();
  await page.reload();
  await expect(description(page)).toHaveAttribute("content", "Version two", aWhile);
  await expect(matrix(page, "R(q)")).toBeVisible();
});

test("another tab goes on in the version before, with its parts, until it is reloaded", async ({
  page,
  context,
  site,
}) => {
  await visit(page);
  const another = await context.newPage();
  await another.goto("./");
  await quaternionField(another).fill("0 1 0 0");
  site.publish("Version two");
  await page.reload();
  await expect(newVersion(another)).toBeVisible(aWhile);
  await reloadIntoNewVersion(page, "Version two");

  await expect(another).toHaveTitle(/ · quatlas$/);
  await expect(quaternionField(another)).toHaveValue("0 1 0 0");
  // The server has this script no more.
  const isThere = await another.evaluate(async () => {
    const script = document.querySelector<HTMLScriptElement>("script[type=module]");
    return (await fetch(script?.src ?? "")).ok;
  });
  expect(isThere).toBe(true);
  await reloadButton(another).click();
  await expect(description(another)).toHaveAttribute("content", "Version two", aWhile);
  await expect(quaternionField(another)).toHaveValue("0 1 0 0");
});

test("another page of the same host keeps nothing of the version before", async ({
  page,
  context,
  site,
}) => {
  await visit(page);
  await context.route("**/elsewhere/", (route) =>
    route.fulfill({ contentType: "text/html", body: "<p>Not of this folder.</p>" }),
  );
  const foreign = await context.newPage();
  await foreign.goto(new URL("/elsewhere/", site.url).href);
  site.publish("Version two");
  await page.reload();
  await expect(newVersion(page)).toBeVisible(aWhile);
  await reloadIntoNewVersion(page, "Version two");
  await expect.poll(() => page.evaluate(async () => (await caches.keys()).length), aWhile).toBe(1);
});

test("a version that is published by half is not kept", async ({ page, site }) => {
  await visit(page);
  site.publish("Version two");
  // The page of a third version beside the list of the second.
  const path = join(site.folder, "index.html");
  const whole = readFileSync(path, "utf8");
  writeFileSync(path, whole.replace("Version two", "Version three"));
  const install = () =>
    page.evaluate(async () => {
      const registration = await navigator.serviceWorker.ready;
      await registration.update();
      const worker = registration.installing;
      if (worker === null) return registration.waiting?.state;
      return new Promise<string>((settled) => {
        worker.addEventListener("statechange", () => settled(worker.state));
      });
    });
  expect(await install()).toBe("redundant");
  await expect(newVersion(page)).toBeHidden();
  await page.reload();
  await expect(page).toHaveTitle(/ · quatlas$/);
  writeFileSync(path, whole);
  expect(await install()).toBe("installed");
  await expect(newVersion(page)).toBeVisible(aWhile);
});

test("the page can be installed: its manifest is whole and its icons have their sizes", async ({
  page,
  site,
}) => {
  await page.goto("./");
  const address = await page
    .locator("link[rel=manifest]")
    .evaluate((link: HTMLLinkElement) => link.href);
  expect(address).toBe(`${site.url}manifest.webmanifest`);
  const manifest = await page.evaluate(async (url) => (await fetch(url)).json(), address);
  expect(manifest).toMatchObject({
    name: expect.stringContaining("quatlas"),
    short_name: "quatlas",
    start_url: "./",
    scope: "./",
    display: "standalone",
  });
  const light = await page.locator("meta[name=theme-color][media*=light]").getAttribute("content");
  expect([manifest.theme_color, manifest.background_color]).toEqual([light, light]);
  const sizeOf = (src: string) =>
    page.evaluate(async (src) => {
      const image = new Image();
      image.src = src;
      await image.decode();
      return `${image.naturalWidth}x${image.naturalHeight}`;
    }, src);
  const drawn = manifest.icons.filter(({ type }: { type: string }) => type === "image/png");
  for (const { src, sizes } of drawn) expect([src, await sizeOf(src)]).toEqual([src, sizes]);
  expect(drawn.map(({ sizes }: { sizes: string }) => sizes)).toEqual([
    "192x192",
    "512x512",
    "512x512",
  ]);
  expect(drawn.at(-1).purpose).toBe("maskable");
  expect(await sizeOf("apple_touch_icon.png")).toBe("180x180");
  // What the browser itself finds wrong with the manifest.
  const session = await page.context().newCDPSession(page);
  const { errors } = await session.send("Page.getAppManifest");
  expect(errors).toEqual([]);
});

test("a store that fails does not stand between the page and the network", async ({
  page,
  site,
}) => {
  const path = join(site.folder, "service_worker.js");
  const worker = readFileSync(path, "utf8");
  // As on a full disk or in a damaged profile, from the moment that it is told to.
  const breaking = `
    addEventListener("message", ({ data }) => {
      if (data !== "break the store") return;
      CacheStorage.prototype.open = CacheStorage.prototype.match = async () => {
        throw new DOMException("Internal error.", "UnknownError");
      };
    });`;
  writeFileSync(path, breaking + worker);
  await visit(page);
  await page.evaluate(() => navigator.serviceWorker.controller?.postMessage("break the store"));
  await page.reload();
  await expect(matrix(page, "R(q)")).toBeVisible();
  // A part of another version is asked of every store.
  writeFileSync(join(site.folder, "assets", "earlier.js"), "");
  expect(await page.evaluate(async () => (await fetch("assets/earlier.js")).ok)).toBe(true);
});
