// The Frames view: what is known between named frames, and where one stands in another, by keyboard.
import type { Page } from "@playwright/test";
import { expect, sidewaysScroll, tabTo, test, violationsOf } from "./support/page.ts";

const answer = (page: Page) => page.locator(".frames-answer");
const asked = (page: Page) => page.getByRole("textbox", { name: "The frame that is asked about" });
const field = (page: Page, row: number, what: string) =>
  page.getByRole("textbox", { name: `Row ${row}: ${what}` });

test("opens on the rig of Yoosefian with the corrected last term, and shows the printed one", async ({
  page,
}) => {
  await page.goto("/#frames");
  await expect(answer(page).getByRole("heading", { name: "I2 in G" })).toBeVisible();
  await expect(answer(page)).toContainText("[1.500000, 1.000000, 2.500000]");
  await expect(answer(page)).toContainText("[1.360221, 0.983679, 2.811300]");
  await expect(answer(page)).toContainText("0.341631 off");
  const [hamilton, jpl] = await page.locator(".frames-product").allTextContents();
  expect(hamilton).toBe("qG I2 = qG I1 ⊙ qI1 C1 ⊙ qC1 C2 ⊙ qI2 C2*");
  expect(jpl).toBe("qG I2 = qI2 C2* ⊗ qC1 C2 ⊗ qI1 C1 ⊗ qG I1");
  await expect(page).toHaveTitle("I2 in G · Frames · quatlas");
  expect(await violationsOf(page)).toEqual([]);
});

test("the question, a row and a point are typed by keyboard, and the address holds them", async ({
  page,
}) => {
  await page.goto("/#frames");
  await tabTo(page, asked(page));
  await page.keyboard.type("c_2");
  // The last answer stays, grey.
  await expect(page.locator(".result.old")).toContainText("I2 in G");
  await expect(page.locator("#frames-problems")).toContainText("Write C2");
  await tabTo(page, page.getByRole("button", { name: "Write C2" }));
  await page.keyboard.press("Enter");
  await expect(answer(page).getByRole("heading", { name: "C2 in G" })).toBeVisible();
  await tabTo(page, page.getByRole("button", { name: "Add a row" }));
  await page.keyboard.press("Enter");
  await field(page, 5, "Frame").focus();
  for (const text of ["radar", "I1", "0 0 √½ √½", "0 0 2"]) {
    await page.keyboard.type(text);
    await page.keyboard.press("Tab");
  }
  await page.keyboard.press("J");
  await asked(page).fill("radar");
  await page.getByRole("textbox", { name: "a point in radar" }).fill("1 0 0");
  await expect(answer(page).getByRole("heading", { name: "radar in G" })).toBeVisible();
  await expect(answer(page)).toContainText("[1, 0, 0]");
  const shown = await answer(page).textContent();
  await page.reload();
  await expect(answer(page)).toHaveText(shown ?? "");
});

test("one row that cannot be read, and frames that do not meet, say what to do", async ({
  page,
}) => {
  await page.goto("/#frames?v=1&frames=C|W||imu|W|1 0 0 0|||C|IMU|1 0 0|||");
  const row = page.locator(".frames-row").nth(1);
  await expect(row).toContainText("3 numbers: a quaternion has 4");
  await expect(answer(page)).toHaveCount(0);
  await field(page, 2, "Rotation").fill("45 about z");
  await row.getByRole("button", { name: "These are radians" }).click();
  await expect(field(page, 2, "Rotation")).toHaveValue("45 rad about z");
  await expect(field(page, 2, "Rotation")).toBeFocused();
  await field(page, 2, "Rotation").fill(
    "[[0, -1, 0, 5], [1, 0, 0, 6], [0, 0, 1, 7], [0, 0, 0, 1]]",
  );
  await expect(row).toContainText("at [5, 6, 7]");
  await field(page, 2, "Rotation").fill("1 0 0 0");
  await expect(page.getByRole("button", { name: "Add a row: C in W" })).toBeVisible();
  await page.getByRole("button", { name: "Call IMU imu" }).click();
  await expect(answer(page).getByRole("heading", { name: "C in W" })).toBeVisible();
  await expect(answer(page)).toContainText("only the rotation is known");
  expect(await violationsOf(page)).toEqual([]);
});

test("a loop that does not close names the row that would close it", async ({ page }) => {
  await page.goto("/#frames");
  await page.getByRole("link", { name: "A loop that does not close" }).click();
  await expect(page.locator(".frames-loops")).toContainText("are its frames exchanged?");
  const picture = page.getByRole("application", { name: "The frames where they stand" });
  const before = await picture.locator("svg").innerHTML();
  await tabTo(page, picture);
  await page.keyboard.press("ArrowLeft");
  expect(await picture.locator("svg").innerHTML()).not.toBe(before);
  await page.setViewportSize({ width: 320, height: 800 });
  expect(await sidewaysScroll(page)).toBeLessThanOrEqual(0);
});
