// The Motion view: a small turn, a rate and where it leads, by keyboard; what goes wrong has an angle.
import type { Page } from "@playwright/test";
import {
  expect,
  openEverything,
  sidewaysScroll,
  tabTo,
  test,
  violationsOf,
} from "./support/page.ts";

const card = (page: Page, name: string) => page.getByRole("region", { name });
const field = (page: Page, name: string) => page.getByRole("textbox", { name });
const golden = "quaternion=rotvec+0.4+-0.7+1.1&rate=0.11+-0.23+0.37&to-rate=&in=10+s";

test("the golden increment, derivative and path stand on the page", async ({ page }) => {
  await page.goto(`/#motion?v=1&${golden}&motion=n10`);
  const turn = card(page, "A small turn");
  await expect(turn).toContainText("q ⊕ δ = q ⊙ Exp(δ)");
  await expect(turn).toContainText("q ⊕ δ = Exp(δ) ⊗ q");
  // G01, in the order of Hamilton, and G06 in that of JPL.
  await expect(turn).toContainText("0.756595x0.192069y−0.334527z0.527982");
  await expect(turn).toContainText("x0.192069y−0.334527z0.527982w0.756595");
  await expect(turn).toContainText("with the other sign7.064° off");
  const derivative = card(page, "The derivative");
  await expect(derivative).toContainText("−0.141415x0.041314y−0.095522z0.140163");
  await expect(derivative).toContainText("[0.122866, −0.249631, 0.352829]");
  const path = card(page, "Over time");
  await expect(path).toContainText("[−0.056082, 0.260684, −0.340053]");
  await expect(path).toContainText("on the other side5.787° off");
  await openEverything(page);
  await expect(path.getByRole("row", { name: /normalised/ })).toContainText("7.34e−2");
  await expect(path.getByRole("row", { name: /Magnus/ })).toContainText("exact");
  expect(await violationsOf(page)).toEqual([]);
});

test("typed by keyboard, and the address holds it", async ({ page }) => {
  await page.goto("/#motion");
  await tabTo(page, field(page, "angular velocity at the beginning"));
  await page.keyboard.press("ControlOrMeta+a");
  await page.keyboard.type("1 2");
  await expect(page.locator(".problem")).toContainText("ω: 2 numbers");
  await page.keyboard.press("ControlOrMeta+a");
  await page.keyboard.type("0 0 90 deg/s");
  await field(page, "angular velocity at the end").fill("");
  await field(page, "duration").fill("1 s");
  const path = card(page, "Over time");
  // 45° and 90° about z, where the other side is the same.
  await expect(path).toContainText("[0, 0, 2.356194]");
  await expect(path).toContainText("on the other sidedoes not show here");
  await page.getByRole("combobox", { name: "Drawn dashed" }).selectOption("with the other sign");
  await page.getByRole("slider", { name: "Moment" }).press("Home");
  await page.keyboard.press("ArrowRight");
  await expect(page.getByRole("slider")).toHaveAttribute("aria-valuetext", "t = 0.025 s");
  await expect(page).toHaveURL(/other-sign\+at1/);
  await page.reload();
  await expect(page.getByRole("slider")).toHaveAttribute("aria-valuetext", "t = 0.025 s");
  await expect(path).toContainText("[0, 0, 2.356194]");
});

test("it plays from the beginning, pauses, and steps; nothing moves by itself under reduced motion", async ({
  page,
}) => {
  await page.goto("/#motion");
  await page.getByRole("button", { name: "Play" }).click();
  await page.getByRole("button", { name: "Pause" }).click();
  const slider = page.getByRole("slider");
  await expect(slider).not.toHaveAttribute("aria-valuetext", "t = 6 s");
  const paused = Number(await slider.inputValue());
  await page.getByRole("button", { name: "One step on" }).click();
  await expect(slider).toHaveValue(String(paused + 1));
  await page.emulateMedia({ reducedMotion: "reduce" });
  await page.reload();
  await expect(page.getByRole("button", { name: "One step back" })).toBeVisible();
  await expect(page.getByRole("button", { name: "Play" })).toHaveCount(0);
});

test("gimbal lock has no rates, and a phone needs no scrolling sideways", async ({ page }) => {
  await page.setViewportSize({ width: 375, height: 800 });
  await page.goto("/#motion?v=1&quaternion=ZYX+0.2+pi/2+1.1+rad");
  await expect(card(page, "The derivative")).toContainText("infinite: gimbal lock");
  await openEverything(page);
  expect(await sidewaysScroll(page)).toBeLessThanOrEqual(0);
});

test("a covariance and a point are typed in folds, and the address holds them", async ({
  page,
}) => {
  await page.goto("/#motion?quaternion=90 deg about y");
  await tabTo(page, page.getByRole("button", { name: "A covariance on the other axes" }));
  await page.keyboard.press("Enter");
  const covariance = page.getByRole("region", { name: "covariance" });
  await expect(covariance.getByRole("table", { name: "P on the world's axes" })).toHaveText(
    /^0.600000\s*0.300000\s*0.200000\s*0.300000\s*0.900000\s*−0.100000/,
  );
  await tabTo(page, covariance.getByRole("textbox"));
  await page.keyboard.press("ControlOrMeta+a");
  await page.keyboard.type("1 2 0, 3 1 0, 0 0 1");
  await expect(covariance.locator(".problem")).toContainText("not symmetric");
  // What was told before stays.
  await expect(covariance.locator(".asked-old")).toContainText("P on the world's axes");
  await page.keyboard.press("ControlOrMeta+a");
  await page.keyboard.type("1 4 9");
  await expect(covariance.getByRole("table", { name: "P on the world's axes" })).toHaveText(
    /^9\s*0\s*0\s*0\s*4\s*0\s*0\s*0\s*1$/,
  );
  await tabTo(page, page.getByRole("button", { name: "How the image of a point changes" }));
  await page.keyboard.press("Enter");
  const point = page.getByRole("region", { name: "point of the body" });
  // x of the body is −z of the world: [1, 2, 3] is at [3, 2, −1].
  await expect(point).toContainText("[3, 2, −1]");
  await expect(
    point.getByRole("table", { name: "by a small turn on the world's axes" }),
  ).toHaveText(/^0\s*−1\s*−2\s*1\s*0\s*3\s*2\s*−3\s*0$/);
  await expect(page).toHaveURL(/covariance=1\+4\+9/);
  await page.reload();
  await expect(covariance.getByRole("textbox")).toHaveValue("1 4 9");
  await expect(point).toContainText("[3, 2, −1]");
  expect(await violationsOf(page)).toEqual([]);
});
