// How often the Tab key has to be pressed to get past a view.
import type { Page } from "@playwright/test";
import { type View, views } from "../../www/model/page_state.ts";
import { expect, openEverything, test } from "./support/page.ts";

/** Of every view, those that come as well; the frame of the page counts. */
const mostStops = 59;

/** All that the Tab key reaches from the start of the page until the focus leaves it. */
async function stops(page: Page): Promise<string[]> {
  const reached: string[] = [];
  // Many more than any view has: a page that cannot be left ends here.
  while (reached.length < 400) {
    await page.keyboard.press("Tab");
    const stop = await page.evaluate(() => {
      const element = document.activeElement;
      if (element === null || element === document.body || "reached" in element) return undefined;
      Object.assign(element, { reached: true });
      return element.outerHTML.slice(0, 160);
    });
    if (stop === undefined) return reached;
    reached.push(stop);
  }
  throw new Error(`the focus never leaves the page: ${reached.slice(-5).join("\n")}`);
}

async function open(page: Page, view: View) {
  await page.goto(`/#${view}`);
  await expect(page.locator("main .loading")).toHaveCount(0);
  await expect(page.locator(".views [aria-current=page]")).toBeVisible();
  // What follows the first result by itself is there too.
  await page.waitForLoadState("networkidle");
}

for (const view of views) {
  test(`the Tab key gets past ${view} soon`, async ({ page }) => {
    await open(page, view);
    const reached = await stops(page);
    expect(reached.length).toBeGreaterThan(10);
    expect(reached.length, reached.join("\n")).toBeLessThanOrEqual(mostStops);
  });
}

test("every number that is edited is one press from another one, and all are reached", async ({
  page,
}) => {
  // With a third column, of a declared convention.
  await page.goto("/#read?function=active&quaternion=0.5+0.1+-0.3+0.8");
  const fields = page.locator("[data-group]");
  await expect(page.locator("[data-group^=declared]").first()).toBeVisible();
  await openEverything(page);
  const groups = new Map<string, string[]>();
  for (const field of await fields.all()) {
    const group = (await field.getAttribute("data-group")) ?? "";
    const name = (await field.getAttribute("aria-label")) ?? "";
    groups.set(group, [...(groups.get(group) ?? []), name]);
  }
  expect(groups.size).toBeGreaterThan(8);
  const focused = () => page.evaluate(() => document.activeElement?.getAttribute("aria-label"));
  for (const [group, names] of groups) {
    const stop = page.locator(`[data-group="${group}"][tabindex="0"]`);
    await expect(stop, group).toHaveCount(1);
    await stop.focus();
    const reached: (string | null | undefined)[] = [await focused()];
    while (reached.length < names.length) {
      await page.keyboard.press("ArrowRight");
      if ((await focused()) === reached.at(-1)) {
        await page.keyboard.press("ArrowDown");
        await page.keyboard.press("Home");
      }
      reached.push(await focused());
    }
    expect(reached).toEqual(names);
  }
});
