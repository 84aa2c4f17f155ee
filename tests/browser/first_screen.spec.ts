// What is on the first screen without scrolling, and that it stays where it is while somebody types.
import type { Locator, Page } from "@playwright/test";
import { expect, matrix, quaternionField, sidewaysScroll, stage, test } from "./support/page.ts";

const region = (page: Page, name: string) => page.getByRole("region", { name, exact: true });
const fact = (page: Page, name: string) =>
  page.locator(".fact").filter({ has: page.getByRole("heading", { name, exact: true }) });

/** What the first screen of Read is for. */
const answersIn = (page: Page): Record<string, Locator> => ({
  "the text": quaternionField(page),
  "its convention": page.getByRole("group", { name: "The text is meant as" }),
  "the vector": page.getByRole("textbox", { name: "vector v" }),
  "q of Hamilton": region(page, "Hamilton").locator(".strip"),
  "q of JPL": region(page, "JPL").locator(".strip"),
  "the matrix of Hamilton": matrix(page, "R(q)"),
  "the matrix of JPL": matrix(page, "C(q)"),
  "the inverse of Hamilton": matrix(page, "inverse of R(q)"),
  "the inverse of JPL": matrix(page, "inverse of C(q)"),
  "the image in Hamilton": region(page, "Hamilton").getByText("v on the body axes"),
  "the image in JPL": region(page, "JPL").getByText("v on the world axes"),
  "the conjugate of Hamilton": region(page, "Hamilton").locator(".rows > :last-child"),
  "the picture": stage(page),
  "the relation": page.getByText("Same numbers, transposed matrices."),
  "the order of a composition": page.getByText("Composition order."),
  "axis and angle": fact(page, "Axis and angle"),
  "the rotation vector": fact(page, "Rotation vector"),
  "Euler angles": fact(page, "Euler angles"),
});

/** One without a remark; one with a note; numbers with signs. */
const addresses = [
  "/",
  "/#read?as=jpl&quaternion=0.1+-0.2+0.4+0.8888194417",
  "/#read?quaternion=ZYX+-130°+-20°+-10°",
];

for (const [width, height] of [
  [1280, 800],
  [1440, 900],
] as const) {
  test(`the answer is on the first screen, ${width} × ${height}`, async ({ page }) => {
    await page.setViewportSize({ width, height });
    for (const address of addresses) {
      await page.goto(address);
      await page.reload();
      for (const [name, answer] of Object.entries(answersIn(page))) {
        // Without scrolling to it, and whole.
        await expect(answer, `${name} at ${address}`).toBeInViewport({ ratio: 1 });
      }
      expect(await page.evaluate(() => scrollY)).toBe(0);
      // The numbers of q and of the matrices are never cut.
      const cut = await page
        .locator(".column .strip input, .column .matrix input")
        .evaluateAll((fields) =>
          fields
            .filter((field) => field.scrollWidth > field.clientWidth)
            .map((field) => field.outerHTML),
        );
      expect(cut, address).toEqual([]);
      expect(await sidewaysScroll(page)).toBeLessThanOrEqual(0);
    }
  });
}

for (const [width, height] of [
  [390, 844],
  [360, 740],
] as const) {
  test(`the first matrix is on the first screen of a phone, ${width} × ${height}`, async ({
    page,
  }) => {
    await page.setViewportSize({ width, height });
    await page.goto("/");
    await expect(matrix(page, "R(q)")).toBeInViewport({ ratio: 1 });
    await expect(matrix(page, "C(q)")).toBeHidden();
    const first = await page.getByRole("textbox", { name: "Hamilton q, w" }).boundingBox();
    expect(first?.y).toBeLessThan(420);
    // The four numbers stand in one row.
    const tops = await page
      .locator(".hamilton .strip input")
      .evaluateAll((fields) => fields.map((field) => field.getBoundingClientRect().top));
    expect(new Set(tops).size).toBe(1);
    expect(tops).toHaveLength(4);
    await expect(stage(page)).toBeAttached();
    expect(await page.evaluate(() => document.documentElement.scrollHeight)).toBeLessThan(2600);
    expect(await sidewaysScroll(page)).toBeLessThanOrEqual(0);

    const shownIn = page.getByRole("radiogroup", { name: "Shown in" });
    await shownIn.getByRole("radio", { name: "JPL" }).check();
    await expect(matrix(page, "R(q)")).toBeHidden();
    await expect(matrix(page, "C(q)")).toBeInViewport({ ratio: 1 });
    // Who declares another convention sees that one.
    await page.getByRole("radio", { name: /^JPL/ }).first().check();
    await expect(shownIn.getByRole("radio", { name: "JPL" })).toBeChecked();
    await page
      .getByRole("radio", { name: /^Hamilton/ })
      .first()
      .check();
    await expect(matrix(page, "R(q)")).toBeVisible();
  });
}

/**
 * Types a text key by key, faster than anybody rests, and tells where the tops of the columns were after
 * each key, and what was said of the text.
 */
const topsWhileTyping = (page: Page, text: string) =>
  page.evaluate(async (text) => {
    const field = document.querySelector<HTMLTextAreaElement>(".ask textarea");
    if (field === null) throw new Error("no field");
    const seen: { after: string; tops: number[]; said: string }[] = [];
    for (let length = 0; length <= text.length; length += 1) {
      field.value = text.slice(0, length);
      field.dispatchEvent(new InputEvent("input", { bubbles: true }));
      // The page is written in microtasks; no timer fires in between.
      for (let tasks = 0; tasks < 20; tasks += 1) await Promise.resolve();
      const columns = [...document.querySelectorAll(".column")];
      seen.push({
        after: field.value,
        tops: columns.map((column) => column.getBoundingClientRect().top),
        said: document.querySelector(".ask-status")?.textContent ?? "",
      });
    }
    return seen;
  }, text);

/** With the first problem comes what every problem is said by. */
async function loadWholeCore(page: Page) {
  const text = await quaternionField(page).inputValue();
  await quaternionField(page).fill("oops");
  await expect(page.locator(".problem")).toBeVisible();
  await quaternionField(page).fill(text);
  await expect(page.locator(".problem")).toHaveCount(0);
  // A rest: what is said has its usual height again.
  await expect(page.locator(".ask-status.typing")).toHaveCount(0);
}

test("the tops of the columns stay where they are while somebody types", async ({ page }) => {
  for (const width of [1280, 390]) {
    await page.setViewportSize({ width, height: 844 });
    for (const typed of ["0.1 -0.2 0.4 .38", "ypr 30 20 10", "2 0 0 cos(1)", "1 0 0 0 0"]) {
      await page.goto("/");
      await page.reload();
      await loadWholeCore(page);
      const columns = page.locator(".column");
      await expect(columns).toHaveCount(2);
      const before = await columns.evaluateAll((found) =>
        found.map((column) => column.getBoundingClientRect().top),
      );
      const seen = await topsWhileTyping(page, typed);
      // The page did answer.
      expect(new Set(seen.map(({ said }) => said)).size).toBeGreaterThan(3);
      for (const { after, tops } of seen) expect(tops, `${width}: ${after}`).toEqual(before);
      // After a rest all of it can be read.
      const hidden = () =>
        page
          .locator(".ask-status")
          .evaluate((status) => status.scrollHeight > status.clientHeight + 2);
      await expect.poll(hidden, `${width}: ${typed}`).toBe(false);
    }
  }
});
