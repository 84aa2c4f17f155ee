// What is folded in Compose and Read and asks the whole core: two rotations compared, many multiplied, one
// in all 16 conventions, and twist and swing; by the keyboard, to the golden numbers.
import type { Locator, Page } from "@playwright/test";
import {
  expect,
  numberOf,
  sidewaysScroll,
  tab,
  test,
  typeOver,
  violationsIn,
} from "./support/page.ts";

const composed = "p=rotvec+0.4+-0.7+1.1&q=rotvec+-0.6+0.25+0.9";

const fold = (page: Page, name: RegExp) => page.getByRole("button", { name, expanded: false });
const region = (page: Page, name: string) => page.getByRole("region", { name, exact: true });

/** The numbers in a row of a card. */
async function rowOf(card: Locator, name: string): Promise<number[]> {
  const row = card.locator(".row", { has: card.page().getByText(name, { exact: true }) });
  const text = await row.locator("code").first().innerText();
  return [...text.matchAll(/[−\d.e]+/g)].map(([number]) => numberOf(number));
}

async function expectRow(card: Locator, name: string, wanted: readonly number[]) {
  await expect
    .poll(
      async () => {
        const found = await rowOf(card, name);
        return (
          found.length === wanted.length &&
          found.every((n, at) => Math.abs(n - (wanted[at] ?? 0)) < 1e-6)
        );
      },
      { message: name, intervals: [30] },
    )
    .toBe(true);
}

test("between p and q: what they are to each other, how far, and the way by a slider", async ({
  page,
}) => {
  await page.goto(`/#compose?v=1&${composed}`);
  const opens = fold(page, /^Between p and q/);
  await opens.focus();
  await page.keyboard.press("Enter");
  const card = region(page, "Between p and q");
  await expect(card).toContainText("p and q are two rotations, 76.4° apart.");
  await expect(page).toHaveURL(/open=between/);
  // G27 and its turns.
  await expectRow(card, "on the body's axes", [-0.38744, 1.273941, -0.064952]);
  await expectRow(card, "on the world's axes", [-1.243625, 0.30896, -0.367691]);
  await expectRow(card, "angle (geodesic)", [76.383154]);
  const copied = card.getByRole("button", { name: "Copy angle (geodesic)" });
  await expect(copied).toHaveAttribute("title", /^76\.38315377093/);
  await expectRow(card, "chordal", [1.748796]);
  await expectRow(card, "‖p − q‖", [0.654297]);
  await expectRow(card, "‖p + q‖", [1.889946]);
  await expect(card).toContainText("q = p ⊙ δq");
  await expect(card).toContainText("q = δq ⊗ p");
  await expectRow(card, "half way, the mean", [0.860461, -0.052897, -0.108373, 0.49504]);
  // The slider moves the numbers and the body of the picture.
  const picture = card.getByRole("application");
  const drawn = await picture.innerHTML();
  await card.getByRole("slider").focus();
  await page.keyboard.press("Home");
  await expectRow(card, "at t = 0", [0.776371, 0.184856, -0.323499, 0.508355]);
  expect(await picture.innerHTML()).not.toBe(drawn);
  await expect(page).toHaveURL(/part=0(&|$)/);
  const part = card.getByRole("textbox", { name: "part t of the way" });
  await part.focus();
  await typeOver(page, "1/3 x");
  await expect(card.locator(".problem")).toContainText("Expected:");
  expect(await violationsIn(page, "section.asked")).toEqual([]);
  await typeOver(page, "2/2");
  await expectRow(card, "at t = 1", [0.849853, -0.284829, 0.118679, 0.427244]);
  await page
    .getByRole("textbox", { name: "quaternion q" })
    .fill("w=-0.7763708832723447 x=-0.18485641079320972 y=0.323498718888117 z=-0.5083551296813268");
  await page
    .getByRole("textbox", { name: "quaternion p" })
    .fill("w=0.7763708832723447 x=0.18485641079320972 y=-0.323498718888117 z=0.5083551296813268");
  await expect(card).toContainText("one rotation by opposite quaternions: q is −p");
});

test("the rate between p and q in a time that is typed, and the half that is forgotten", async ({
  page,
}) => {
  await page.goto("/#compose?v=1&p=1+0+0+0&q=60deg+about+x&open=between");
  const card = region(page, "Between p and q");
  const time = card.getByRole("textbox", { name: "time from p to q" });
  await expect(card).toContainText("A time, as 0.25 s or 250 ms");
  await time.focus();
  await typeOver(page, "250 ms");
  // The question of questions.json: who forgets the half angle says 2.0944.
  await expectRow(card, "ω on the body's axes", [4.18879, 0, 0]);
  await expectRow(card, "ω on the world's axes", [4.18879, 0, 0]);
  await expect(card).toContainText("rad/s · 240°/s about x");
  await expect(card).toContainText("it is 30° short of q");
  await expect(page).toHaveURL(/within=250\+ms/);
  await typeOver(page, "0 s");
  await expect(card.locator(".problem")).toContainText("Expected: a duration above zero");
  expect(await violationsIn(page, "section.asked")).toEqual([]);
  await page.goto("/#compose?v=1&p=45deg+about+z&q=45deg+about+z&open=between&within=2+s");
  await page.reload();
  await expectRow(card, "ω on the body's axes", [0, 0, 0]);
  await expect(card).not.toContainText("short of q");
});

test("each product as rotation vector and Euler angles, and its inverse in both notations", async ({
  page,
}) => {
  await page.goto(`/#compose?v=1&${composed}`);
  await fold(page, /^p ⊙ q = q ⊗ p as rotation vector/).focus();
  await page.keyboard.press("Enter");
  const forms = region(page, "p ⊙ q in other forms");
  // G25, and the inverse of its quaternion by hand.
  await expectRow(forms, "rotation vector", [-0.62586, -0.969051, 1.653037]);
  const { w, x, y, z } = { w: 0.533654, x: -0.262576, y: -0.406561, z: 0.693524 };
  await expectRow(forms, "(p ⊙ q)⁻¹ = q⁻¹ ⊙ p⁻¹", [w, -x, -y, -z]);
  await expectRow(forms, "(q ⊗ p)⁻¹ = p⁻¹ ⊗ q⁻¹", [-x, -y, -z, w]);
  await page.getByText(/^The other order/).click();
  await fold(page, /^q ⊙ p = p ⊗ q as rotation vector/).focus();
  await page.keyboard.press("Enter");
  const swapped = region(page, "q ⊙ p in other forms");
  // The inverse of the product that the test of many factors multiplies in reverse.
  await expectRow(swapped, "(q ⊙ p)⁻¹ = p⁻¹ ⊙ q⁻¹", [0.533654, -0.134511, -0.040986, -0.83393]);
  await expect(page).toHaveURL(/open=forms,other-forms|open=forms%2Cother-forms/);
  expect(await violationsIn(page, "section.asked")).toEqual([]);
  await page.setViewportSize({ width: 360, height: 780 });
  expect(await sidewaysScroll(page)).toBeLessThanOrEqual(0);
  // In JPL the declared product is p ⊗ q.
  await page.goto(`/#compose?v=1&${composed}&as=jpl&open=forms`);
  await expectRow(swapped, "(p ⊗ q)⁻¹ = q⁻¹ ⊗ p⁻¹", [-0.134511, -0.040986, -0.83393, 0.533654]);
});

test("more than two: factors are added, inverted and taken away again", async ({ page }) => {
  await page.goto(`/#compose?v=1&${composed}&open=chain`);
  const card = region(page, "More than two");
  // G25.
  await expectRow(card, "rotation vector", [-0.62586, -0.969051, 1.653037]);
  await card.getByRole("button", { name: "Add a factor" }).focus();
  await page.keyboard.press("Enter");
  const added = card.getByRole("textbox", { name: "factor 3" });
  await added.focus();
  await typeOver(page, "rotvec -0.6 0.25 0.9");
  await card.getByRole("checkbox").nth(2).focus();
  await page.keyboard.press("Space");
  // p ⊙ q ⊙ q⁻¹ is p.
  await expectRow(card, "rotation vector", [0.4, -0.7, 1.1]);
  await expect(card.getByRole("heading", { name: "JPL" })).toContainText("r1−1 ⊗ q ⊗ p");
  await expect(page).toHaveURL(/factors=~%2F|factors=~\//);
  await added.focus();
  await typeOver(page, "1 2");
  await expect(card.locator(".problem")).toContainText("Expected:");
  expect(await violationsIn(page, "section.asked")).toEqual([]);
  await card.getByRole("button", { name: "Remove factor 3" }).focus();
  await page.keyboard.press("Enter");
  await expectRow(card, "rotation vector", [-0.62586, -0.969051, 1.653037]);
  // The other order is another rotation, and its quaternion the one that Compose shows.
  await card.getByRole("checkbox", { name: "multiplied in reverse" }).focus();
  await page.keyboard.press("Space");
  await expect(card.getByRole("heading", { name: "JPL" })).toContainText("p ⊗ q");
  await expectRow(card.locator(".hamilton"), "product", [0.533654, 0.134511, 0.040986, 0.83393]);
  await page.setViewportSize({ width: 360, height: 780 });
  expect(await sidewaysScroll(page)).toBeLessThanOrEqual(0);
});

test("one rotation in all 16 conventions, and a row that is chosen is declared", async ({
  page,
}) => {
  await page.goto("/#read?v=1&quaternion=rotvec+0.4+-0.7+1.1");
  await fold(page, /^The same rotation in all 16/).focus();
  await page.keyboard.press("Enter");
  const card = region(page, "The same rotation in all 16 conventions").first();
  await expect(card.getByRole("radio")).toHaveCount(16);
  // G32, the four arrays of eight conventions in two orders.
  await expect(card.locator(".atlas-numbers code")).toHaveText([
    "[0.776371, 0.184856, −0.323499, 0.508355]",
    "[0.776371, −0.184856, 0.323499, −0.508355]",
    "[0.184856, −0.323499, 0.508355, 0.776371]",
    "[−0.184856, 0.323499, −0.508355, 0.776371]",
  ]);
  const row = (name: RegExp) => card.getByRole("row", { name });
  await expect(row(/My Lab/)).toContainText("R(q): body → world");
  await expect(row(/JPL of Yoosefian/)).toContainText("C(q): body → world");
  await expect(row(/world → body ?JPL ?C/)).toContainText("δq∘q");
  expect(await violationsIn(page, "section.asked")).toEqual([]);
  await row(/JPL of Yoosefian/)
    .getByRole("radio")
    .focus();
  await page.keyboard.press("Space");
  await expect(page).toHaveURL(/as=jpl&direction=body-to-world/);
  await expect(row(/JPL of Yoosefian/).getByRole("radio")).toBeChecked();
  await tab(page, "Compose").click();
  await expect(card).toHaveCount(0);
  await page.setViewportSize({ width: 360, height: 780 });
  await page.goBack();
  await expect(card).toBeVisible();
  expect(await sidewaysScroll(page)).toBeLessThanOrEqual(0);
});

test("twist and swing about an axis that is typed", async ({ page }) => {
  await page.goto("/#read?v=1&quaternion=yaw+65+pitch+20+roll+-35+deg&open=swing-twist");
  const card = region(page, "Twist and swing");
  await expectRow(card, "twist about the axis", [71.364244]);
  await expect(card).toContainText("39.668");
  const axis = card.getByRole("textbox", { name: "axis" });
  await axis.focus();
  await typeOver(page, "0 0 0");
  await expect(card.locator(".problem")).toContainText("the axis has length zero");
  await typeOver(page, "0 0 -3");
  await expectRow(card, "twist about the axis", [-71.364244]);
});
