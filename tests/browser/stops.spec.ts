// Notes that stop the reader: shown as such, heard, and answered with a button.
import type { Page } from "@playwright/test";
import {
  expect,
  matrix,
  numbersOf,
  quaternionField,
  sidewaysScroll,
  tabTo,
  test,
  violationsOf,
} from "./support/page.ts";

const stops = (page: Page) => page.locator(".notes .note-stops");
const heard = (page: Page) => page.locator("[data-said='result']");

const axisAndAngle = "0.36 0.48 0.8 75";

test("a norm far from 1 stops the reader, before all other notes", async ({ page }) => {
  await page.goto("/");
  await quaternionField(page).fill(axisAndAngle);
  await expect(stops(page)).toHaveText([
    /A quaternion of norm 75\? Or a point, an axis and an angle/,
  ]);
  await expect(page.locator(".notes li")).toHaveText([/norm 75/, /do not tell their order/]);
  // The report still comes.
  await expect(page.locator(".result")).toHaveClass(/current/);
  await expect(quaternionField(page)).toHaveAttribute("aria-invalid", "false");
  await expect(quaternionField(page)).toHaveAccessibleDescription(/A quaternion of norm 75\?/);
  await expect(heard(page)).toHaveText(/^Check q: A quaternion of norm 75\? .* Result: a rotation/);
  await expect(stops(page).locator(".fix-label")).toHaveText([
    "A quaternion of norm 75",
    "Axis and angle",
  ]);
  await expect(stops(page).locator(".fix-text")).toHaveText(["axis-angle [0.36 0.48 0.8] 75deg"]);
  expect(await violationsOf(page)).toEqual([]);
  // It is gone with what it asked, and what was heard too.
  await quaternionField(page).fill("0.6 0 0 0.8");
  await expect(stops(page)).toHaveCount(0);
  await expect(heard(page)).toHaveText(/^Result: a rotation/);
  await expect(quaternionField(page)).not.toHaveAttribute("aria-describedby");
});

test("what the numbers are is said by keyboard, and taken back", async ({ page }) => {
  await page.goto("/");
  await quaternionField(page).fill(axisAndAngle);
  const button = stops(page).getByRole("button", { name: "Axis and angle" });
  await tabTo(page, button);
  await page.keyboard.press("Enter");
  await expect(quaternionField(page)).toHaveValue("axis-angle [0.36 0.48 0.8] 75deg");
  await expect(quaternionField(page)).toBeFocused();
  await expect(page.getByRole("status")).toContainText("Done: Axis and angle.");
  await expect(page.locator(".notes li")).toHaveCount(0);
  // Row y, column x: 2 (xy + wz) with w = cos 37.5° and (x, y, z) = sin 37.5° (0.36, 0.48, 0.8)
  await expect
    .poll(async () => (await numbersOf(matrix(page, "R(q)")))[3])
    .toBeCloseTo(0.900_82, 5);
  await page.keyboard.press("ControlOrMeta+z");
  await expect(quaternionField(page)).toHaveValue(axisAndAngle);
  await expect(stops(page)).toHaveCount(1);

  // The first with its key: then the norm is only told.
  await quaternionField(page).focus();
  await page.keyboard.press("Alt+Enter");
  await expect(quaternionField(page)).toHaveValue(`quaternion ${axisAndAngle}`);
  await expect(stops(page)).toHaveCount(0);
  await expect(page.locator(".notes")).toContainText("The norm is 75.006666");
});

test("in Compose and Translate the same is asked, each of its own text", async ({ page }) => {
  await page.goto("/#compose?p=0+0+1+1.5708&q=0.6+0+0+0.8");
  const p = page.getByRole("textbox", { name: "quaternion p" });
  await expect(stops(page)).toHaveText([/A quaternion of norm 1\.86\?/]);
  await expect(p).toHaveAccessibleDescription(/norm 1\.86/);
  await expect(page.getByRole("textbox", { name: "quaternion q" })).not.toHaveAttribute(
    "aria-describedby",
  );
  await expect(heard(page)).toHaveText(/^Check p: /);
  await stops(page).getByRole("button", { name: "Axis and angle" }).click();
  await expect(p).toHaveValue("axis-angle [0 0 1] 1.5708rad");

  await page.goto("/#translate?translated=12+-3+0+1.57&from=eigen&to=ros-tf2");
  await expect(stops(page)).toHaveText([/A quaternion of norm 12\.5\?/]);
  await stops(page).getByRole("button", { name: "Position and yaw" }).click();
  await expect(quaternionField(page)).toHaveValue("1.57rad about z");
});

test("other notes that stop are shown alike, and those that only tell are not", async ({
  page,
}) => {
  await page.goto("/");
  for (const [text, said] of [
    ["ZYX 30 20 10", /The angles have no unit/],
    ["0 -1 0 1 0 0 0 0 1", /Nothing marks the rows/],
    ["Quaternion(0.6, 0, 0, 0.8)", /is not known here/],
  ] as const) {
    await quaternionField(page).fill(text);
    await expect(stops(page), text).toHaveText([said]);
  }
  for (const text of ["0.6 0 0 0.8", "-0.6 + 0.8k", "quaternion 1 2 3 4", "0.5 0.5 0.5 0.5"]) {
    await quaternionField(page).fill(text);
    await expect(page.locator(".notes li").first(), text).toBeVisible();
    await expect(stops(page), text).toHaveCount(0);
  }
});

test("numbers that are edited on the page are a quaternion of whatever norm", async ({ page }) => {
  await page.goto("/#read?quaternion=0.6+%2B+0.8k");
  const w = page.getByRole("textbox", { name: "Hamilton q, w" });
  await w.fill("412");
  await expect(page.locator(".notes")).toContainText("The norm is 412");
  await expect(stops(page)).toHaveCount(0);
  // And so they are where they are carried, and where the sign is changed.
  await w.press("Tab");
  await page.locator(".fact").getByRole("button", { name: "Write −q" }).click();
  await expect(quaternionField(page)).toHaveValue("qw=-412 qx=0 qy=0 qz=-0.8");
  await page
    .getByRole("link", { name: /^Compose with this/ })
    .first()
    .click();
  const q = page.getByRole("textbox", { name: "quaternion q" });
  await expect(q).toHaveValue("qw=-412 qx=0 qy=0 qz=-0.8");
  await expect(stops(page)).toHaveCount(0);
});

test("of a text with two meanings one is chosen, by keyboard, and taken back", async ({ page }) => {
  await page.goto("/");
  await quaternionField(page).fill("[0, 0, 1] 0.7");
  const buttons = page.locator(".problem-help .fix");
  await expect(buttons.locator(".fix-label")).toHaveText(["Axis and angle", "A quaternion"]);
  await expect(buttons.locator(".fix-text")).toHaveText([
    "axis-angle [0, 0, 1] 0.7",
    "q = [0, 0, 1] 0.7",
  ]);
  // No key chooses.
  await expect(page.locator("[aria-keyshortcuts='Alt+Enter']")).toHaveCount(0);
  await quaternionField(page).focus();
  await page.keyboard.press("Alt+Enter");
  await expect(quaternionField(page)).toHaveValue("[0, 0, 1] 0.7");
  expect(await violationsOf(page)).toEqual([]);
  await tabTo(page, buttons.last());
  await page.keyboard.press("Enter");
  await expect(quaternionField(page)).toHaveValue("q = [0, 0, 1] 0.7");
  await expect(quaternionField(page)).toBeFocused();
  await expect(page.locator(".notes")).toContainText("The norm is 1.220656");
  await page.keyboard.press("ControlOrMeta+z");
  await expect(buttons).toHaveCount(2);
  await buttons.first().click();
  await expect(quaternionField(page)).toHaveValue("axis-angle [0, 0, 1] 0.7");
});

test("zeros that were rounded and millimetres are refused, with the norm", async ({ page }) => {
  await page.goto("/");
  const problem = page.locator(".problem-message");
  await quaternionField(page).fill("0 0 0 6.1e-17");
  await expect(problem).toContainText("zero but for rounding (norm 6.1e-17)");
  await quaternionField(page).fill("X=412.3 Y=-96.1 Z=877.9 W=41.4");
  await expect(problem).toContainText("its norm is 975.5");
  await expect(page.locator(".problem-help .fix")).toHaveCount(0);
});

test("on a phone and in the dark the question and its buttons have room", async ({ page }) => {
  await page.setViewportSize({ width: 360, height: 740 });
  await page.emulateMedia({ colorScheme: "dark" });
  for (const [text, buttons, count] of [
    ["-50 0.6 0.64 0.48", stops(page).getByRole("button"), 3],
    ["[0, 0, 1] 0.7", page.locator(".problem-help .fix"), 2],
  ] as const) {
    await page.goto(`/#read?quaternion=${encodeURIComponent(text)}`);
    await expect(buttons).toHaveCount(count);
    expect(await sidewaysScroll(page)).toBeLessThanOrEqual(0);
    const boxes = await buttons.evaluateAll((found) =>
      found.map((button) => button.getBoundingClientRect().toJSON()),
    );
    for (const [at, { top, left, right, height }] of boxes.entries()) {
      expect(height).toBeGreaterThanOrEqual(24);
      expect(right).toBeLessThanOrEqual(360);
      const before = boxes[at - 1];
      expect(!before || top >= before.bottom || left >= before.right, `${text} ${at}`).toBe(true);
    }
    expect(await violationsOf(page)).toEqual([]);
  }
});
