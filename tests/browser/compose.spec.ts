// Compose: the product as declared comes first, with its equal and what it does to the body, on the
// first screen; it leads on to other views, and stays where it is while somebody types.
import type { Locator, Page } from "@playwright/test";
import {
  expect,
  matrix,
  numberOf,
  numbersOf,
  openEverything,
  sidewaysScroll,
  test,
  textsOf,
  violationsIn,
} from "./support/page.ts";

const texts = "p=ZYX+10°+20°+30°&q=ZYX+40°+50°+60°";

/**
 * By matrices alone, with R(p) = Rz(10°) Ry(20°) Rx(30°) and R(q) = Rz(40°) Ry(50°) Rx(60°): the angle from
 * the trace and the axis from the skew part of R(p) R(q), and of R(q) R(p), as C(p) C(q) is its transpose.
 */
const worked = [
  {
    as: "hamilton",
    declared: "Hamilton: p ⊙ q",
    equal: "JPL: q ⊗ p",
    pair: "p ⊙ q equals q ⊗ p",
    scalarFirst: [0.601529, 0.474072, 0.622789, 0.159852],
    rotation: "106.041084° about [0.593443, 0.779606, 0.200102]",
    hamiltonRows: [
      [0.173163, 0.398183, 0.900813],
      [0.782805, 0.499406, -0.371228],
      [-0.597688, 0.769444, -0.225221],
    ],
  },
  {
    as: "jpl",
    declared: "JPL: p ⊗ q",
    equal: "Hamilton: q ⊙ p",
    pair: "p ⊗ q equals q ⊙ p",
    scalarFirst: [0.601529, 0.485666, 0.633304, 0.034903],
    rotation: "106.041084° about [0.607956, 0.792768, 0.043692]",
    hamiltonRows: [
      [0.195416, 0.573158, 0.795803],
      [0.657139, 0.525821, -0.540076],
      [-0.727998, 0.628493, -0.27389],
    ],
  },
] as const;

const card = (page: Page, name: string) => page.getByRole("region", { name, exact: true });
const components = (page: Page, name: string) => card(page, name).locator(".strip dd");
const numbersIn = async (found: Locator) => (await textsOf(found)).map(numberOf);
const scalarLast = ([w, ...vector]: readonly number[]) => [...vector, w];
const transposed = (rows: readonly (readonly number[])[]) =>
  rows.map((_, at) => rows.map((row) => row[at]));

async function open(page: Page, fragment: string) {
  await page.goto(`/#compose?${fragment}`);
  await expect(page.locator(".stage svg").first()).toBeVisible();
}

test("the product as declared, its equal and its rotation stand on the first screen", async ({
  page,
}) => {
  for (const { as, declared, equal, pair, scalarFirst, rotation, hamiltonRows } of worked) {
    await open(page, `${texts}&as=${as}`);
    await expect(page.getByRole("region", { name: pair })).toBeVisible();
    // Hamilton's numbers and JPL's, scalar first and last, and transposed matrices.
    const [hamilton, jpl] = as === "hamilton" ? [declared, equal] : [equal, declared];
    const symbolOf = (name: string) => name.split(": ")[1];
    await expect.poll(() => numbersIn(components(page, hamilton))).toEqual(scalarFirst);
    expect(await numbersIn(components(page, jpl))).toEqual(scalarLast(scalarFirst));
    expect(await numbersOf(matrix(page, `R(${symbolOf(hamilton)})`))).toEqual(hamiltonRows.flat());
    expect(await numbersOf(matrix(page, `C(${symbolOf(jpl)})`))).toEqual(
      transposed(hamiltonRows).flat(),
    );
    await expect(page.locator(".badge")).toHaveCount(1);
    await expect(card(page, declared).locator(".badge")).toHaveText("as declared");
    const both = [card(page, declared), card(page, equal)] as const;
    for (const each of both) {
      await expect(each.locator(".product-turn .row-value")).toHaveText(rotation);
    }
    // Beside each other, the declared one first, and nothing of them below the window.
    for (const size of [
      { width: 1280, height: 800 },
      { width: 1440, height: 900 },
    ]) {
      await page.setViewportSize(size);
      for (const each of both) await expect(each).toBeInViewport({ ratio: 1 });
      const [left, right] = [await both[0].boundingBox(), await both[1].boundingBox()];
      expect(left?.x).toBeLessThan(right?.x ?? 0);
      expect(left?.y).toBe(right?.y);
      expect(await sidewaysScroll(page)).toBeLessThanOrEqual(0);
    }
  }
});

test("the product as declared leads on to Read and to Translate", async ({ page }) => {
  for (const { as, declared, scalarFirst } of worked) {
    await open(page, `${texts}&as=${as}`);
    const [name = "", product = ""] = declared.split(": ");
    const sorted = as === "hamilton" ? scalarFirst : scalarLast(scalarFirst);
    await page.getByRole("link", { name: `Read this: ${product}` }).click();
    await expect(page.getByRole("radio", { name: new RegExp(`^${name}`) })).toBeChecked();
    const read = page.getByRole("region", { name, exact: true }).locator(".strip dd");
    await expect.poll(() => numbersIn(read)).toEqual(sorted);
    await page.goBack();
    await page.getByRole("link", { name: `Translate this: ${product}` }).click();
    const from = page.locator(".translation-end").first();
    await expect(from).toContainText(name);
    await expect.poll(() => numbersIn(from.locator("dd"))).toEqual(sorted);
  }
});

test("a convention beyond both presets has its product first, and leads on with that", async ({
  page,
}) => {
  await page.setViewportSize({ width: 1280, height: 800 });
  await open(page, `${texts}&direction=world-to-body`);
  const own = card(page, "Your convention: p ⊙ q");
  await expect(own).toBeInViewport({ ratio: 1 });
  await expect(own.locator(".badge")).toHaveText("as declared");
  // From world to body it is the conjugate of Hamilton's q ⊙ p, and the same rotation of the body.
  await expect(own.locator(".strip dd")).toHaveText([
    "0.601529",
    "−0.485666",
    "−0.633304",
    "−0.034903",
  ]);
  await expect(own.locator(".row-value")).toHaveText(worked[1].rotation);
  await expect(page.getByRole("region", { name: "q ⊙ p equals p ⊗ q" })).toBeInViewport();
  await own.getByRole("link", { name: "Read this: p ⊙ q" }).click();
  const read = page.getByRole("region", { name: "Your convention" }).locator(".strip dd");
  await expect.poll(() => numbersIn(read)).toEqual([0.601529, -0.485666, -0.633304, -0.034903]);
});

test("the products stay where they are while either text is typed, key by key", async ({
  page,
}) => {
  await page.clock.install();
  await open(page, "");
  await page.clock.pauseAt(new Date(Date.now() + 60_000));
  const top = () =>
    page
      .locator(".pair")
      .first()
      .evaluate((pair) => pair.getBoundingClientRect().top);
  for (const width of [1280, 390]) {
    await page.setViewportSize({ width, height: 844 });
    for (const operand of ["p", "q"]) {
      const field = page.getByRole("textbox", { name: `quaternion ${operand}` });
      await field.fill("1");
      await page.clock.runFor(1000);
      const before = await top();
      await field.press("End");
      // A problem comes and goes, and at the end there is a note of its own.
      for (const key of " 0 0 0 x") {
        await page.keyboard.press(key === " " ? "Space" : key);
        expect(await top(), `${operand}, ${width} px wide`).toBe(before);
      }
      await page.clock.runFor(1000);
      await expect(page.locator(`#problem-${operand}`)).toBeVisible();
      await field.fill("ZYX 10 20 30");
      await page.clock.runFor(1000);
    }
  }
});

test("on a phone the numbers come first, then the pictures, and the rest", async ({ page }) => {
  await page.setViewportSize({ width: 390, height: 844 });
  // Without units, so that both texts have a note.
  await open(page, `${texts.replaceAll("°", "")}&as=jpl`);
  const declared = card(page, "JPL: p ⊗ q");
  const parts = [".ask", ".strip", ".product-turn", ".picture", ".road", ".composed > .fold"];
  const topOf = (part: string) =>
    page
      .locator(part)
      .first()
      .evaluate((node) => node.getBoundingClientRect().top);
  for (const [width, height] of [
    [390, 844],
    [360, 740],
    [320, 740],
  ] as const) {
    await page.setViewportSize({ width, height });
    await expect(declared.locator(".strip")).toBeInViewport({ ratio: 1 });
    // At 320 px its numbers stand two and two.
    if (width > 320) await expect(declared.locator(".product-turn")).toBeInViewport({ ratio: 1 });
    const bottom = await declared.evaluate((node) => node.getBoundingClientRect().bottom);
    expect(bottom).toBeLessThanOrEqual(1.5 * height);
    const tops = await Promise.all(parts.map(topOf));
    expect(tops).toEqual([...tops].sort((a, b) => a - b));
    expect(await sidewaysScroll(page), `${width} px`).toBeLessThanOrEqual(0);
  }
  // The other one stands in its place.
  const equal = card(page, "Hamilton: q ⊙ p");
  await expect(equal).toBeHidden();
  const { y } = (await declared.boundingBox()) ?? {};
  await page.getByRole("radio", { name: "Hamilton q ⊙ p" }).check();
  await expect(declared).toBeHidden();
  expect((await equal.boundingBox())?.y).toBe(y);
});

test("axe finds nothing: dark, with a convention of one's own, and light, beside a problem", async ({
  page,
}) => {
  test.slow();
  await page.emulateMedia({ colorScheme: "dark" });
  await open(page, `${texts}&direction=world-to-body&digits=all`);
  await openEverything(page);
  expect(await violationsIn(page, ".composed")).toEqual([]);
  await page.emulateMedia({ colorScheme: "light" });
  await page.setViewportSize({ width: 390, height: 844 });
  await page.getByRole("textbox", { name: "quaternion q" }).fill("0.6 0 x 0.8");
  await expect(page.locator("#problem-q")).toBeVisible();
  expect(await violationsIn(page, ".composed")).toEqual([]);
});
