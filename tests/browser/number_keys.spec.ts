// A group of numbers is one stop of the Tab key: the arrow keys lead through it, Enter and typing edit.
import type { Locator, Page } from "@playwright/test";
import { expect, matrix, quaternionField, tabTo, test } from "./support/page.ts";

const opened = "w=0.5 x=0.1 y=-0.3 z=0.8";

async function open(page: Page) {
  await page.goto("/#read?quaternion=w%3D0.5+x%3D0.1+y%3D-0.3+z%3D0.8");
  await expect(quaternionField(page)).toHaveValue(opened);
}

const field = (page: Page, name: string) => page.getByRole("textbox", { name, exact: true });
const cell = (page: Page, row: number, column: number) =>
  field(page, `R(q), row ${row}, column ${column}`);

test("the arrow keys reach every number of a matrix, and change none", async ({ page }) => {
  await open(page);
  await tabTo(page, cell(page, 1, 1));
  for (const row of [1, 2, 3]) {
    for (const column of [1, 2, 3]) {
      await expect(cell(page, row, column)).toBeFocused();
      // The last one leads nowhere.
      await page.keyboard.press("ArrowRight");
    }
    await expect(cell(page, row, 3)).toBeFocused();
    await page.keyboard.press("Home");
    await page.keyboard.press("ArrowDown");
  }
  for (const [keys, row, column] of [
    ["ArrowUp", 2, 1],
    ["ArrowLeft", 2, 1],
    ["End", 2, 3],
    ["ArrowDown", 3, 3],
    ["ArrowDown", 3, 3],
    ["Control+Home", 1, 1],
    ["ArrowUp", 1, 1],
    ["Control+End", 3, 3],
    ["ArrowLeft", 3, 2],
    // A key that would type nothing.
    ["Space", 3, 2],
  ] as const) {
    await page.keyboard.press(keys);
    await expect(cell(page, row, column), keys).toBeFocused();
  }
  await expect(quaternionField(page)).toHaveValue(opened);
  // The Tab key leaves the matrix, and comes back to the number that it left.
  await page.keyboard.press("Tab");
  await expect(cell(page, 3, 2)).not.toBeFocused();
  await expect(page.locator("table input:focus")).toHaveCount(0);
  await page.keyboard.press("Shift+Tab");
  await expect(cell(page, 3, 2)).toBeFocused();
});

test("in one row all arrows lead on", async ({ page }) => {
  await open(page);
  for (const names of [
    ["Hamilton q, w", "Hamilton q, x", "Hamilton q, y", "Hamilton q, z"],
    ["angle in degrees", "axis, x", "axis, y", "axis, z"],
    ["rotation vector, x", "rotation vector, y", "rotation vector, z"],
    ["yaw in degrees", "pitch in degrees", "roll in degrees"],
  ]) {
    const fields = names.map((name) => field(page, name));
    await fields[0]?.focus();
    for (const [at, key] of ["ArrowRight", "ArrowDown"].entries()) {
      await page.keyboard.press(key);
      await expect(fields[at + 1] as Locator).toBeFocused();
    }
    await page.keyboard.press("End");
    await expect(fields.at(-1) as Locator).toBeFocused();
    await page.keyboard.press("ArrowUp");
    await expect(fields.at(-2) as Locator).toBeFocused();
    await page.keyboard.press("Home");
    await expect(fields[0] as Locator).toBeFocused();
  }
  await expect(quaternionField(page)).toHaveValue(opened);
});

test("Enter and F2 edit with all digits, and in there the arrows move and step", async ({
  page,
}) => {
  await open(page);
  const x = field(page, "Hamilton q, x");
  const y = field(page, "Hamilton q, y");
  await y.focus();
  await expect(y).toHaveValue("−0.300000");
  for (const key of ["Enter", "F2"]) {
    await page.keyboard.press(key);
    await expect(y).toHaveValue("-0.3");
    await page.keyboard.press("ArrowUp");
    await expect(y).toHaveValue("-0.29");
    await page.keyboard.press("ArrowRight");
    await page.keyboard.press("ArrowLeft");
    await page.keyboard.press("Backspace");
    await expect(y).toHaveValue("-0.9");
    await page.keyboard.press("Escape");
    await expect(y).toBeFocused();
    await expect(y).toHaveValue("−0.300000");
    await expect(quaternionField(page)).toHaveValue(opened);
  }
  // Typed over, taken, and the arrows lead on.
  await page.keyboard.type(".25");
  await expect(y).toHaveValue(".25");
  await page.keyboard.press("Enter");
  await expect(y).toHaveValue("0.250000");
  await page.keyboard.press("ArrowLeft");
  await expect(x).toBeFocused();
  await page.keyboard.type("1/8");
  await page.keyboard.press("Tab");
  await expect(page.locator(".number:focus")).toHaveCount(0);
  await expect(quaternionField(page)).toHaveValue("qw=0.5, qx=(1/8), qy=.25, qz=0.8");
  // Undo moves the cursor into the number; what is typed replaces it all the same.
  await y.focus();
  await page.keyboard.press("ControlOrMeta+z");
  await expect(quaternionField(page)).toHaveValue("qw=0.5, qx=0.1, qy=.25, qz=0.8");
  await page.keyboard.press("ControlOrMeta+z");
  await expect(y).toHaveValue("−0.300000");
  await page.keyboard.type("7");
  await expect(y).toHaveValue("7");
});

test("a number that is copied or cut has all its digits", async ({ page, context }) => {
  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  await page.goto("/");
  const w = field(page, "Hamilton q, w");
  for (const key of ["c", "x"]) {
    await page.evaluate(() => navigator.clipboard.writeText(""));
    await w.focus();
    await expect(w).toHaveValue("0.923880");
    await page.keyboard.press(`ControlOrMeta+${key}`);
    await expect
      .poll(() => page.evaluate(() => navigator.clipboard.readText()))
      .toBe("0.9238795325112867");
  }
  await expect(w).toHaveValue("");
});

test.describe("under a finger", () => {
  test.use({ hasTouch: true, isMobile: true, viewport: { width: 390, height: 844 } });

  test("a tap edits at once, in letters that no phone enlarges, and nothing moves", async ({
    page,
  }) => {
    await page.goto("/");
    await expect(matrix(page, "R(q)")).toBeVisible();
    for (const name of ["R(q), row 2, column 2", "Hamilton q, w", "yaw in degrees"]) {
      const number = field(page, name);
      await number.evaluate((node) => node.scrollIntoView({ block: "center" }));
      const places = () =>
        page.locator(".answer-grid :is(.number-box, .copy, .row, h2)").evaluateAll((found) =>
          found.map((node) => {
            const { left, top, width, height } = node.getBoundingClientRect();
            return [left, top + scrollY, width, height].map((size) => Math.round(size * 10));
          }),
        );
      const before = await places();
      const atRest = await number.inputValue();
      await number.tap();
      await expect(number).toBeFocused();
      await expect(number).toHaveClass(/editing/);
      await expect(number).toHaveCSS("font-size", "16px");
      expect(await places(), name).toEqual(before);
      // The whole number is selected.
      await page.keyboard.type("0.5");
      await expect(number).toHaveValue("0.5");
      await page.keyboard.press("Escape");
      await expect(number).toHaveValue(atRest);
    }
  });
});
