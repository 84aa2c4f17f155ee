// Which Euler angles are these? Three, four or nine numbers beside an attitude, in the Identify view.
import type { Page } from "@playwright/test";
import {
  expect,
  quaternionField,
  sidewaysScroll,
  tabTo,
  test,
  typeOver,
  violationsIn,
} from "./support/page.ts";

const fold = (page: Page) => page.getByText("Which Euler angles are these?", { exact: true });
const card = (page: Page) => page.getByRole("region", { name: "Which Euler angles are these?" });
const field = (page: Page, name: string) => card(page).getByRole("textbox", { name });
const sentence = (page: Page) => page.locator(".numbers-sentence");
const readings = (page: Page) => card(page).getByRole("row");

const engine =
  "Euler angles YXZ about the moving axes, printed as x, y, z, in degrees. No other reading fits; the next is 17° off.";

test("is folded until it is asked, by keyboard, and then shows an example with its answer", async ({
  page,
}) => {
  await page.goto("/#identify");
  await expect(fold(page)).toBeVisible();
  await expect(card(page)).toBeHidden();
  await tabTo(page, page.locator(".numbers-fold > summary"));
  await page.keyboard.press("Enter");
  await expect(sentence(page)).toHaveText(engine);
  await expect(readings(page)).toHaveCount(4);
  await expect(readings(page).first()).toContainText("fits");
  await expect(readings(page).nth(1)).toContainText("17° off");
  await expect(page.getByRole("status")).toContainText(engine);
  // The address holds what is asked, and a link opens it.
  await expect(page).toHaveURL(/numbers=40\.00,\+335\.00,\+70\.00/);
  await page.reload();
  await expect(sentence(page)).toHaveText(engine);
  await fold(page).click();
  await expect(card(page)).toBeHidden();
});

test("numbers that are typed are told, and the reading opens in Read with its sequence", async ({
  page,
}) => {
  await page.goto("/#identify?v=1&numbers=1+2+3");
  await tabTo(page, field(page, "the numbers"));
  await typeOver(page, "30 20 10");
  await page.keyboard.press("Tab");
  await expect(field(page, "the attitude")).toBeFocused();
  // SciPy: Rotation.from_euler("ZXZ", [30, 20, 10], degrees=True).as_quat(scalar_first=True)
  await page.keyboard.type("0.925417 0.171010 0.030154 0.336824");
  await expect(sentence(page)).toHaveText(
    /^Euler angles ZXZ about the moving axes, in degrees\. No other reading fits; the next is .*° off\.$/,
  );
  await page.getByRole("link", { name: /^Read this: Euler angles ZXZ/ }).click();
  await expect(quaternionField(page)).toHaveValue("ZXZ 30 20 10 deg");
  await expect(page).toHaveURL(/euler=ZXZ/);
  await page.goBack();
  await expect(field(page, "the numbers")).toHaveValue("30 20 10");
});

test("a rewriting and nine numbers are told", async ({ page }) => {
  await page.goto("/#identify?v=1&numbers=30+20+10&beside=1+0+0+0");
  await card(page).getByRole("link", { name: "A rewriting" }).click();
  await expect(sentence(page)).toHaveText(
    "The quaternion, w x y z, with y and z flipped in the world (180° about x). No other reading fits.",
  );
  await expect(readings(page)).toHaveCount(1);
  await card(page).getByRole("link", { name: "Nine numbers" }).click();
  await expect(sentence(page)).toHaveText(/^The transposed matrix, times 2\.5\. /);
  // The button: the matrix as it is meant.
  await card(page)
    .getByRole("link", { name: /^Read this: the transposed/ })
    .click();
  await expect(quaternionField(page)).toHaveValue(/^0\.054\d* -0\.94\d* -0\.32\d*\n/);
});

test("numbers are read as declared: of JPL the last is the scalar", async ({ page }) => {
  await page.goto("/#identify?v=1&numbers=(q1,+q2,+q3,+q4)");
  await expect(sentence(page)).toHaveText("The quaternion, w x y z. No other reading fits.");
  await card(page).getByRole("radio", { name: /^JPL/ }).check();
  await expect(sentence(page)).toHaveText("The quaternion, x y z w. No other reading fits.");
});

test("what does not fit says how far the nearest is, and what cannot be read what was expected", async ({
  page,
}) => {
  await page.goto("/#identify?v=1&numbers=30+20+10&beside=0.6+0.8+0+0");
  await expect(sentence(page)).toHaveText(/^No reading fits: the nearest is .*° off\.$/);
  await field(page, "the numbers").fill("30 20");
  await expect(card(page)).toContainText("2 numbers beside the attitude.");
  await expect(card(page)).toContainText("Expected: three, four or nine numbers");
  await expect(card(page).locator("mark")).toHaveText("30 20");
  await expect(field(page, "the numbers")).toHaveAttribute("aria-invalid", "true");
  await field(page, "the attitude").fill("0 0 0 oops");
  await expect(card(page).locator(".problem")).toHaveCount(2);
  // An emptied field asks nothing, and the fold stays open.
  await field(page, "the numbers").fill("");
  await expect(card(page).locator(".problem")).toHaveCount(0);
  await expect(field(page, "the attitude")).toBeVisible();
});

test("one angle alone decides nothing, and that is said", async ({ page }) => {
  await page.goto("/#identify?v=1&numbers=0+0+90&beside=0.707107+0+0+0.707107");
  await expect(sentence(page)).toHaveText(
    "9 readings fit, and these numbers do not tell them apart. Three different angles do, such as 30 20 10.",
  );
});

for (const scheme of ["light", "dark"] as const) {
  test(`has no violations and fits a phone, ${scheme}`, async ({ page }) => {
    await page.emulateMedia({ colorScheme: scheme });
    await page.setViewportSize({ width: 320, height: 700 });
    await page.goto("/#identify?v=1&numbers=30+20&beside=0.6+0.8+0+0");
    await expect(card(page)).toContainText("2 numbers");
    expect(await violationsIn(page, ".numbers-fold")).toEqual([]);
    await field(page, "the numbers").fill("30 20 10");
    await expect(sentence(page)).toContainText("No reading fits");
    expect(await violationsIn(page, ".numbers-fold")).toEqual([]);
    expect(await sidewaysScroll(page)).toBe(0);
  });
}
