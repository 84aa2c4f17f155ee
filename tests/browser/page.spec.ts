// The page in a real browser, by keyboard.
import {
  expect,
  matrix,
  numbersOf,
  quaternionField,
  tab,
  tabTo,
  test,
  textsOf,
  typeOver,
  violationsOf,
} from "./support/page.ts";

test("opens on 45° about z with every output filled", async ({ page }) => {
  await page.goto("/");
  await expect(page.getByRole("heading", { name: "Hamilton" })).toBeVisible();
  expect(await numbersOf(matrix(page, "R(q)"))).toEqual([
    0.707107, -0.707107, 0, 0.707107, 0.707107, 0, 0, 0, 1,
  ]);
  expect(await numbersOf(matrix(page, "C(q)"))).toEqual([
    0.707107, 0.707107, 0, -0.707107, 0.707107, 0, 0, 0, 1,
  ]);
  expect(await numbersOf(matrix(page, "inverse of R(q)"))).toEqual(
    await numbersOf(matrix(page, "C(q)")),
  );
  // The lecture's point (1, 1, 0)/√2 lies on the x axis of the turned frame.
  await expect(page.getByText("[1, 0, 0]")).toBeVisible();
  await expect(page.getByRole("textbox", { name: "angle in degrees" })).toHaveValue("45");
  await expect(page.getByRole("textbox", { name: "axis, z" })).toHaveValue("1");
});

test("a Hamilton quaternion typed by keyboard", async ({ page }) => {
  await page.goto("/");
  await tabTo(page, quaternionField(page));
  await typeOver(page, "1/2 + i/2 + j/2 + k/2");
  // 120° about (1, 1, 1): x to y, y to z, z to x.
  await expect.poll(() => numbersOf(matrix(page, "R(q)"))).toEqual([0, 0, 1, 1, 0, 0, 0, 1, 0]);
  expect(await numbersOf(matrix(page, "C(q)"))).toEqual([0, 1, 0, 0, 0, 1, 1, 0, 0]);
  await expect(page.getByRole("status")).toHaveText(/a rotation by 120.*° about/);
});

test("a JPL quaternion typed and declared by keyboard", async ({ page }) => {
  await page.goto("/");
  await tabTo(page, quaternionField(page));
  await typeOver(page, "1/√2 0 0 1/√2");
  await tabTo(page, page.getByRole("radio", { name: /^Hamilton/ }));
  await page.keyboard.press("ArrowRight");
  await expect(page.getByRole("radio", { name: /^JPL/ })).toBeChecked();
  // x y z w: a quarter turn about x, world to body.
  await expect.poll(() => numbersOf(matrix(page, "C(q)"))).toEqual([1, 0, 0, 0, 0, 1, 0, -1, 0]);
  expect(await numbersOf(matrix(page, "R(q)"))).toEqual([1, 0, 0, 0, 0, -1, 0, 1, 0]);
  await expect(page.getByText("read as x y z w")).toBeVisible();
});

test("an error keeps the last good result, says where it is, and is recovered from", async ({
  page,
}) => {
  await page.goto("/");
  await tabTo(page, quaternionField(page));
  await typeOver(page, "0.5 0.5 ½ ½");
  await expect.poll(() => numbersOf(matrix(page, "R(q)"))).toEqual([0, 0, 1, 1, 0, 0, 0, 1, 0]);
  await page.keyboard.type(" oops");
  const field = quaternionField(page);
  await expect(field).toHaveAttribute("aria-invalid", "true");
  await expect(field).toHaveAccessibleDescription(/oops is not a known number, unit or function/);
  await expect(page.locator("mark")).toHaveText("oops");
  await expect(page.getByText("Showing the last valid result.", { exact: true })).toBeVisible();
  expect(await numbersOf(matrix(page, "R(q)"))).toEqual([0, 0, 1, 1, 0, 0, 0, 1, 0]);
  await expect(page.getByRole("status")).toHaveText(
    /^Problem in q: oops is not a known number, unit or function\./,
  );

  for (const _ of " oops") await page.keyboard.press("Backspace");
  await expect(field).toHaveAttribute("aria-invalid", "false");
  await expect(page.getByText("Showing the last valid result.", { exact: true })).toBeHidden();
});

test("the place of a problem stands right after an emoji", async ({ page }) => {
  await page.goto("/");
  await quaternionField(page).fill('{"🙂": [0, 0, oops, 1]}');
  await expect(page.locator("mark")).toHaveText("oops");
});

test("reloading the address gives the same page", async ({ page }) => {
  await page.goto("/");
  await quaternionField(page).fill("x: 0.1\ny: -0.2\nz: 0.38\nw: 0.92");
  await page.getByRole("textbox", { name: "vector v" }).fill("1, -2, ½");
  await page.getByRole("radio", { name: /^JPL/ }).check();
  await page.getByRole("radio", { name: "all" }).focus();
  await page.keyboard.press("Space");
  await expect(page).toHaveURL(/as=jpl.*digits=all/);
  // What comes after the first result is there too.
  const allIsThere = () => expect(page.locator(".picture-wait, .fold-wait")).toHaveCount(0);
  const shown = async () => [
    await page.locator(".read-as").innerHTML(),
    // Ids are given in the order in which parts come, and what a field held at first is no news.
    (await page.locator(".result").innerHTML())
      .replace(/P\d+-\d+/g, "P")
      .replace(/ (?:checked|selected|value)="[^"]*"/g, ""),
    await textsOf(page.locator(":has(> input[type=text])")),
  ];
  await allIsThere();
  const before = await shown();
  await page.reload();
  await expect(matrix(page, "R(q)")).toBeVisible();
  await allIsThere();
  expect(await shown()).toEqual(before);
  await expect(quaternionField(page)).toHaveValue("x: 0.1\ny: -0.2\nz: 0.38\nw: 0.92");
});

test("an address with a problem opens on the example, marked as such", async ({ page }) => {
  await page.goto("/#read?quaternion=1+2+3");
  await expect(page.getByText("q: 3 numbers: a quaternion has 4.", { exact: true })).toBeVisible();
  await expect(page.getByText("Showing the opening example.", { exact: true })).toBeVisible();
  await expect(matrix(page, "R(q)")).toBeVisible();
});

test("composes by keyboard: four products, equal ones tied", async ({ page }) => {
  await page.goto("/");
  await tabTo(page, tab(page, "Compose"));
  await page.keyboard.press("Enter");
  await tabTo(page, page.getByRole("textbox", { name: "quaternion p" }));
  await typeOver(page, "√½ + √½ k");
  await page.keyboard.press("Tab");
  await typeOver(page, "√½ + √½ i");
  await expect(page.getByRole("heading", { name: "p ⊙ q: first q, then p" })).toBeVisible();
  // R(z) R(x) by hand, and its transpose.
  await expect.poll(() => numbersOf(matrix(page, "R(p ⊙ q)"))).toEqual([0, 0, 1, 1, 0, 0, 0, 1, 0]);
  expect(await numbersOf(matrix(page, "C(q ⊗ p)"))).toEqual([0, 1, 0, 0, 0, 1, 1, 0, 0]);
  await expect(page.getByRole("region", { name: "p ⊙ q equals q ⊗ p" })).toBeVisible();
  await tabTo(page, page.getByText("The other order: q ⊙ p = p ⊗ q"));
  await page.keyboard.press("Enter");
  await expect(page.getByRole("region", { name: "q ⊙ p equals p ⊗ q" })).toBeVisible();
  expect(await numbersOf(matrix(page, "R(q ⊙ p)"))).toEqual([0, -1, 0, 0, 0, -1, 1, 0, 0]);
  await expect(page).toHaveURL(/#compose\?/);
});

test("going back returns to the view before, with what was typed", async ({ page }) => {
  await page.goto("/");
  await quaternionField(page).fill("4 3 2 1");
  await tab(page, "Compose").click();
  await expect(page.getByRole("textbox", { name: "quaternion p" })).toBeVisible();
  await page.goBack();
  await expect(quaternionField(page)).toHaveValue("4 3 2 1");
  // An example can be left the same way.
  await page.getByRole("link", { name: "ROS message" }).click();
  await expect(quaternionField(page)).toHaveValue(/^x: 0\.0/);
  await page.goBack();
  await expect(quaternionField(page)).toHaveValue("4 3 2 1");
});

test("an old result keeps the convention that it was declared in", async ({ page }) => {
  await page.goto("/#read?quaternion=0+0+0.6+0.8");
  await quaternionField(page).fill("0 0 0.6 x");
  await page.getByRole("radio", { name: /^JPL/ }).check();
  const hamilton = page.getByRole("region", { name: "Hamilton" });
  await expect(hamilton.getByText("as declared")).toBeVisible();
});

test("the result does not move while a text is typed", async ({ page }) => {
  await page.setViewportSize({ width: 1280, height: 900 });
  await page.goto("/");
  await expect(matrix(page, "R(q)")).toBeVisible();
  const top = () => page.locator(".result").evaluate((node) => node.getBoundingClientRect().top);
  const before = await top();
  const field = quaternionField(page);
  for (const text of ["", "1", "1 0 0 0", "0.5 0.5 0.5 0.4", "-0.1 0.2 0.3 oops", "1/0 0 0 1"]) {
    await field.fill(text);
    expect(await top(), text).toBe(before);
  }
});

test("a copy has every digit, whatever is shown", async ({ page, context }) => {
  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  await page.goto("/#read?digits=4");
  await page.getByRole("button", { name: "Copy C(q) v" }).click();
  await expect(page.getByText("C(q) v copied", { exact: true })).toBeVisible();
  await page.getByRole("button", { name: "Copy rotation vector" }).click();
  await expect
    .poll(() => page.evaluate(() => navigator.clipboard.readText()))
    .toMatch(/^\[0, 0, 0\.785398163397448\d?\]$/);
});

test("a panic of the core is said in words and the page goes on", async ({ page }) => {
  // A core whose analyze traps once, as a panic does.
  await page.addInitScript(() => {
    const compile = WebAssembly.instantiateStreaming;
    WebAssembly.instantiateStreaming = async (source, imports) => {
      const { module, instance } = await compile(source, imports);
      const analyze = instance.exports["analyze"] as (...numbers: unknown[]) => unknown;
      const exports = {
        ...instance.exports,
        analyze: (...numbers: unknown[]) => {
          const field = document.querySelector("textarea");
          if (field?.value.includes("panic")) throw new WebAssembly.RuntimeError("unreachable");
          return analyze(...numbers);
        },
      };
      return { module, instance: { exports } as unknown as WebAssembly.Instance };
    };
  });
  await page.goto("/");
  await quaternionField(page).fill("0 panic");
  await expect(page.getByRole("alert")).toHaveText(/mistake in quatlas.*unreachable/);
  await expect(matrix(page, "R(q)")).toBeVisible();
  await quaternionField(page).fill("0.6 + 0.8i");
  await expect(page.getByRole("alert")).toBeHidden();
  await expect(page.getByRole("textbox", { name: "angle in degrees" })).toHaveValue("106.260205");
});

for (const colorScheme of ["light", "dark"] as const) {
  for (const address of [
    "/",
    "/#compose",
    "/#read?quaternion=1+0+0",
    "/#read?quaternion=2+0+0+1",
  ]) {
    test(`no accessibility violation: ${colorScheme}, ${address}`, async ({ page }) => {
      await page.emulateMedia({ colorScheme });
      await page.goto(address);
      await expect(page.locator("table").first()).toBeVisible();
      expect(await violationsOf(page)).toEqual([]);
    });
  }
}

const longName = `/#read?quaternion=${"a_long_name_of_a_".repeat(12)}Quaternion(1,2,3,4)`;
const addresses = ["/", "/#compose", "/#read?digits=all", "/#compose?digits=all", longName];
for (const width of [320, 768, 1280]) {
  for (const address of addresses) {
    test(`no sideways scroll at ${width} px: ${address}`, async ({ page }) => {
      await page.setViewportSize({ width, height: 800 });
      await page.goto(address);
      await expect(page.locator("table").first()).toBeVisible();
      const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
      expect(overflow).toBeLessThanOrEqual(0);
    });
  }
}

test("the page serves the optimised wasm of the build, and explains itself without script", async ({
  page,
  browser,
}) => {
  const [response] = await Promise.all([
    page.waitForResponse((answer) => answer.url().endsWith(".wasm")),
    page.goto("/"),
  ]);
  const { readFileSync } = await import("node:fs");
  const built = readFileSync(new URL("../../pkg/small/quatlas_small_bg.wasm", import.meta.url));
  expect(Buffer.compare(await response.body(), built)).toBe(0);

  const context = await browser.newContext({ javaScriptEnabled: false });
  const plain = await context.newPage();
  await plain.goto(page.url());
  await expect(plain.getByText("Same numbers, transposed matrices.")).toBeVisible();
  await context.close();
});
