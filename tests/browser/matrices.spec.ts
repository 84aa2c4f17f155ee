// Which convention does a library of matrices use? In the Identify view, by the keyboard.
import type { Page } from "@playwright/test";
import { expect, sidewaysScroll, tabTo, test, typeOver, violationsIn } from "./support/page.ts";

const summary = "Which convention does a library of matrices use?";
const card = (page: Page) => page.getByRole("region", { name: "A library of matrices" });
const field = (page: Page, name: string) => card(page).getByRole("textbox", { name, exact: true });
const row = (page: Page, name: string) => card(page).getByRole("row", { name });

test("is folded until it is asked, by keyboard, and opens on an example with its answer", async ({
  page,
}) => {
  await page.goto("/#identify");
  await tabTo(page, page.getByRole("button", { name: summary }));
  await page.keyboard.press("Enter");
  await expect(card(page).getByRole("status")).toHaveText("One of 16 conventions prints this.");
  await expect(row(page, "Times a column")).toContainText("world → body");
  await expect(row(page, "Its labels")).toContainText("change coordinates (passive)");
  await expect(row(page, "A body’s matrix is labelled")).toContainText("world to body");
  await expect(row(page, "A small turn φ")).toContainText("the axes of the body");
  await expect(row(page, "It turns the body by").getByRole("cell")).toHaveText("φ");
  await expect(page).toHaveURL(/open=matrices/);
  expect(await violationsIn(page, "section.asked")).toEqual([]);
  // Labels that move vectors, and a formal sign.
  await card(page).getByRole("link", { name: "Its labels move vectors" }).focus();
  await page.keyboard.press("Enter");
  await expect(row(page, "Times a column")).toContainText("body → world");
  await expect(row(page, "Its labels")).toContainText("move vectors (active)");
  await expect(row(page, "A body’s matrix is labelled")).toContainText("world to body");
  await expect(row(page, "A small turn φ")).toContainText("the axes of the world");
  await expect(row(page, "It turns the body by").getByRole("cell")).toHaveText("−φ");
  await card(page).getByRole("link", { name: "Read its matrices so" }).click();
  await expect(page).toHaveURL(/#read.*matrix=active&rows=world-to-body/);
});

test("is typed from empty fields, and what is not told is open", async ({ page }) => {
  await page.goto("/#identify?v=1&open=matrices&matrices=~");
  const status = card(page).getByRole("status");
  await expect(status).toHaveText("16 of 16 conventions print this.");
  await expect(row(page, "Times a column")).toContainText("open: the body turned by 90° tells");
  await tabTo(page, field(page, "the body turned by 90°"));
  await page.keyboard.type("0 -1 0 1 0 0 0 0 1");
  await expect(row(page, "Times a column")).toContainText("body → world");
  await expect(status).toHaveText("8 of 16 conventions print this.");
  await page.keyboard.press("Tab");
  await expect(field(page, "A to B")).toBeFocused();
  await page.keyboard.type("1 0 0 0 0 -1 0 1 0");
  await page.keyboard.press("Tab");
  await page.keyboard.type("0 -1 0 1 0 0 0 0 1");
  await page.keyboard.press("Tab");
  // B to C times A to B.
  await page.keyboard.type("0 0 1 1 0 0 0 1");
  await expect(card(page).locator(".problem:visible")).toContainText("Expected:");
  expect(await violationsIn(page, "section.asked")).toEqual([]);
  await page.keyboard.type(" 0");
  await expect(row(page, "Its labels")).toContainText("change coordinates (passive)");
  await expect(row(page, "A body’s matrix is labelled")).toContainText("body to world");
  await expect(status).toHaveText("4 of 16 conventions print this.");
  // The address holds what was typed.
  await expect(page).toHaveURL(/matrices=0\+-1/);
  await page.reload();
  await expect(field(page, "A to C")).toHaveValue("0 0 1 1 0 0 0 1 0");
  await field(page, "A to C").focus();
  await typeOver(page, "");
  await page.keyboard.press("Backspace");
  await expect(row(page, "Its labels")).toContainText("open:");
  await page.emulateMedia({ colorScheme: "dark" });
  await page.setViewportSize({ width: 360, height: 780 });
  expect(await violationsIn(page, "section.asked")).toEqual([]);
  expect(await sidewaysScroll(page)).toBeLessThanOrEqual(0);
});
