// The tabs and the parts of Libraries: where each leads, which is current, and that nothing moves.
import type { Page } from "@playwright/test";
import { views } from "../../www/model/page_state.ts";
import { partsOf, tabNames, tabOf } from "../../www/model/tabs.ts";
import { expect, part, sidewaysScroll, tab, test } from "./support/page.ts";

test("every view stands in one tab", () => {
  expect(tabNames.flatMap(partsOf).toSorted()).toEqual([...views].toSorted());
  for (const view of views) expect(partsOf(tabOf(view))).toContain(view);
});

/** Which links say that they are current. */
const current = (page: Page) => page.locator("a[aria-current=page]").allTextContents();

test("Libraries opens on Translate, and then on the part that was used last", async ({ page }) => {
  await page.goto("/#read?quaternion=4+3+2+1");
  await expect(page.locator(".views a")).toHaveText([
    "Read",
    "Compose",
    "Motion",
    "Frames",
    "Libraries",
  ]);
  await expect(page.locator(".parts")).toHaveCount(0);
  await tab(page, "Libraries").click();
  await expect(page).toHaveURL(/#translate\?v=1&quaternion=4\+3\+2\+1$/);
  await expect(page.locator(".parts a")).toHaveText(["Translate", "Identify", "All libraries"]);
  await expect.poll(() => current(page)).toEqual(["Libraries", "Translate"]);
  await part(page, "Identify").click();
  await expect.poll(() => current(page)).toEqual(["Libraries", "Identify"]);
  await tab(page, "Compose").click();
  await expect.poll(() => current(page)).toEqual(["Compose"]);
  await expect(page.locator(".parts")).toHaveCount(0);
  await tab(page, "Libraries").click();
  await expect.poll(() => current(page)).toEqual(["Libraries", "Identify"]);
  // Each of them was a link: going back returns, one by one.
  for (const place of ["Compose", "Identify", "Translate"]) {
    await page.goBack();
    await expect.poll(async () => (await current(page)).at(-1)).toBe(place);
  }
});

test("a part that was opened by its address is the one that is come back to", async ({ page }) => {
  await page.goto("/#libraries?find=jpl");
  await expect.poll(() => current(page)).toEqual(["Libraries", "All libraries"]);
  await tab(page, "Read").click();
  await tab(page, "Libraries").click();
  await expect.poll(() => current(page)).toEqual(["Libraries", "All libraries"]);
  await expect(page.getByRole("searchbox")).toHaveValue("jpl");
});

test("on a phone the tabs are one row, and so are the parts; they stay where they are", async ({
  page,
}) => {
  await page.setViewportSize({ width: 320, height: 740 });
  await page.goto("/#translate");
  await expect(page.locator(".result")).toBeVisible();
  const places = () =>
    page
      .locator(".views a, .parts a")
      .evaluateAll((links: HTMLElement[]) =>
        links.map((link) => [link.offsetLeft, link.offsetTop]),
      );
  const before = await places();
  const rows = new Set(before.map(([, top]) => top));
  expect(before).toHaveLength(8);
  expect(rows.size).toBe(2);
  expect(await sidewaysScroll(page)).toBeLessThanOrEqual(0);
  await part(page, "Identify").click();
  await expect(page.locator(".answer")).toBeVisible();
  expect(await places()).toEqual(before);
});
