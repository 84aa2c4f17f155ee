// What the tests of the page share: a console error or a foreign request fails any test.
import AxeBuilder from "@axe-core/playwright";
import { test as base, expect, type Locator, type Page } from "@playwright/test";

export const test = base.extend<{ page: Page }>({
  page: async ({ page, baseURL }, use) => {
    waitForProgram(page);
    await page.addInitScript(haveLetters);
    const errors: string[] = [];
    const foreign: string[] = [];
    page.on("console", (message) => {
      if (message.type() === "error") errors.push(message.text());
    });
    page.on("pageerror", (error) => errors.push(error.message));
    page.on("request", (request) => {
      const url = request.url();
      const isOwn = url.startsWith(baseURL ?? "") || /^(data|blob):/.test(url);
      if (!isOwn) foreign.push(url);
    });
    await use(page);
    expect(errors, "console errors").toEqual([]);
    expect(foreign, "requests that leave the origin").toEqual([]);
  },
});

/** Resolves once the program is in the page, which shows its example before. */
export const started = (page: Page) =>
  page.waitForFunction(() => document.querySelector("[data-starting]") === null);

/** A page that is opened is there with its program, but where only its answer is waited for. */
function waitForProgram(page: Page) {
  const { goto, reload } = page;
  page.goto = async (...given) => {
    const answer = await goto.apply(page, given);
    if (given[1]?.waitUntil !== "commit") await started(page);
    return answer;
  };
  page.reload = async (...given) => {
    const answer = await reload.apply(page, given);
    if (given[0]?.waitUntil !== "commit") await started(page);
    return answer;
  };
}

/** As for who was here before: the page waits for its letters, however slow the machine is. */
function haveLetters() {
  try {
    localStorage.setItem("quatlas-letters", "kept");
  } catch {
    // On an empty page there is no storage.
  }
}

/** As on a slow line at the first visit: the page is written in the letters of the system. */
export function haveNoLetters(page: Page) {
  return page.addInitScript(() => {
    try {
      localStorage.removeItem("quatlas-letters");
    } catch {}
    const now = performance.now.bind(performance);
    performance.now = () => now() + 1000;
  });
}

/** Holds the answers to some requests of a page back, until what this returns is called. */
export async function holdBack(page: Page, address: string): Promise<() => void> {
  let allow = () => {};
  const allowed = new Promise<void>((resolve) => {
    allow = resolve;
  });
  await page.route(address, async (route) => {
    await allowed;
    await route.continue();
  });
  return allow;
}

const minus = "−";

/** What stands in elements, be it a text or the value of a field. */
export function textsOf(elements: Locator): Promise<string[]> {
  return elements.evaluateAll((found) =>
    found.map((element) => element.querySelector("input")?.value ?? element.textContent ?? ""),
  );
}

/** The cells of a matrix as numbers, row by row. */
export async function numbersOf(table: Locator): Promise<number[]> {
  return (await textsOf(table.locator("td"))).map(numberOf);
}

export const numberOf = (text: string) => Number(text.trim().replace(minus, "-"));

/** A matrix to be read is a table, one to be edited a grid. */
export function matrix(page: Page, name: string) {
  const named = { name, exact: true };
  return page.getByRole("table", named).or(page.getByRole("grid", named));
}

export const quaternionField = (page: Page) => page.getByRole("textbox", { name: "quaternion q" });

/** The link to a tab. */
export const tab = (page: Page, name: string) =>
  page.getByRole("navigation", { name: "Views" }).getByRole("link", { name, exact: true });

/** The link to a part of the tab that is open. */
export const part = (page: Page, name: string) =>
  page.getByRole("main").getByRole("navigation").getByRole("link", { name, exact: true });

/** The address of a picture seen from the world's x axis: y to the right, z up. */
export const fromX = "look=0,0";
export const stage = (page: Page) =>
  page.getByRole("application", { name: "Picture of the rotation" });

/** The middle of the body, as the finger meets it. */
export async function bodyOn(page: Page) {
  await stage(page).evaluate((node) => node.scrollIntoView({ block: "center" }));
  const box = await stage(page).boundingBox();
  if (!box) throw new Error("no picture");
  return { box, x: box.x + box.width / 2 + 4, y: box.y + box.height / 2 + 12 };
}

/** Tabs from the start of the page until the element has the focus. */
export async function tabTo(page: Page, element: Locator) {
  for (let presses = 0; presses < 300; presses += 1) {
    if (await element.evaluate((node) => node === document.activeElement)) return;
    await page.keyboard.press("Tab");
  }
  throw new Error("the element cannot be reached with the Tab key");
}

export async function press(page: Page, key: string, times: number) {
  for (let presses = 0; presses < times; presses += 1) await page.keyboard.press(key);
}

export async function typeOver(page: Page, text: string) {
  await page.keyboard.press("ControlOrMeta+a");
  await page.keyboard.type(text);
}

/** Opens every part of the page that can be, with what comes after the first result. */
export async function openEverything(page: Page) {
  await expect(page.locator(".fold-wait")).toHaveCount(0);
  await page.evaluate(() => {
    for (const details of document.querySelectorAll("details")) details.open = true;
  });
  // Behind a dialog nothing is opened.
  if ((await page.getByRole("dialog").count()) > 0) return;
  // These come with the whole core.
  const closed = page.locator(".fold > button[aria-expanded=false]");
  while ((await closed.count()) > 0) await closed.first().click();
  await expect(page.locator(".fold-wait")).toHaveCount(0);
}

/** How much wider than the window the page is. */
export function sidewaysScroll(page: Page) {
  return page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
}

/** The violations that axe finds, with every part of the page open. */
export async function violationsOf(page: Page) {
  await openEverything(page);
  return violationsIn(page, "html");
}

/** The violations that axe finds in a part of the page. */
export async function violationsIn(page: Page, part: string) {
  const { violations } = await new AxeBuilder({ page }).include(part).analyze();
  return violations.map(({ id, nodes }) => [id, nodes.map(({ html }) => html)]);
}

export { expect };
