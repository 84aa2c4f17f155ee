// The Identify view: from what a library prints to a sentence for an issue, by keyboard.
import type { Locator, Page } from "@playwright/test";
import {
  expect,
  openEverything,
  sidewaysScroll,
  tabTo,
  test,
  typeOver,
  violationsOf,
} from "./support/page.ts";

const printed = (page: Page, number: number) =>
  page.getByRole("textbox", { name: `observation ${number} printed` });
const told = (page: Page, number: number) => page.locator(".told").nth(number - 1);
const sentence = (page: Page) => page.locator(".sentence p");
const row = (page: Page, choice: string) =>
  page.locator(".choices tr").filter({ has: page.getByRole("rowheader", { name: choice }) });

async function startEmpty(page: Page) {
  await page.goto("/#identify");
  await tabTo(page, page.getByRole("button", { name: "Start with an empty sheet" }));
  await page.keyboard.press("Enter");
  await expect(printed(page, 1)).toBeFocused();
}

/** Tabs backwards until the element has the focus. */
async function tabBackTo(page: Page, element: Locator) {
  for (let presses = 0; presses < 40; presses += 1) {
    if (await element.evaluate((node) => node === document.activeElement)) return;
    await page.keyboard.press("Shift+Tab");
  }
  throw new Error("the element cannot be reached with Shift and Tab");
}

/** Answers the questions in their order, each with Enter. */
async function answer(page: Page, ...answers: string[]) {
  for (const [at, text] of answers.entries()) {
    await expect(printed(page, at + 1)).toBeFocused();
    await page.keyboard.type(text);
    await page.keyboard.press("Enter");
  }
}

test("opens on a library with JPL's product that is not JPL", async ({ page }) => {
  await page.goto("/#identify");
  await expect(page.getByText("an example")).toBeVisible();
  await expect(page.locator(".left")).toHaveText("8 of 256 behaviours are left");
  await expect(page.getByRole("region", { name: "Between Hamilton and JPL" })).toContainText(
    "Not JPL: Shuster product, but R(q).",
  );
  await expect(page.getByRole("link", { name: "DirectXMath", exact: true })).toHaveAttribute(
    "href",
    /^#libraries\?.*library=directxmath/,
  );
  await expect(row(page, "Product").locator(".settled")).toContainText("settled: Shuster");
  await expect(row(page, "Rotates a column by").locator(".settled")).toContainText("R(q)");
});

test("three questions lead to a sentence by keyboard: Hamilton, stored x y z w", async ({
  page,
  context,
}) => {
  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  await startEmpty(page);
  await answer(page, "[1. 0. 0. 0.]", "[3. 1. 2.]", "[[0 0 1] [1 0 0] [0 1 0]]");
  await tabBackTo(page, page.getByRole("textbox", { name: "Library" }));
  await page.keyboard.type("tf2");
  const words =
    "tf2 multiplies Hamilton (i*j = k), takes x y z w in its constructor, stores and prints x y z w, rotates a column vector by R(q), prints R(q) as the matrix of q (for column vectors) and lets the right operand b of a*b act first. That is Hamilton.";
  await expect(sentence(page)).toHaveText(words);
  await expect(page.getByRole("status")).toContainText(words);
  const copy = page.getByRole("button", { name: "Copy the sentence for an issue" });
  await tabTo(page, copy);
  await page.keyboard.press("Enter");
  await expect.poll(() => page.evaluate(() => navigator.clipboard.readText())).toBe(words);
  await expect(page.getByRole("region", { name: /^Records that match/ })).toContainText(
    "SciPy Rotation",
  );
});

test("the same three questions tell DirectXMath from JPL", async ({ page }) => {
  await startEmpty(page);
  await answer(page, "-1 0 0 0", "3 1 2", "[[0, 1, 0], [0, 0, 1], [1, 0, 0]]");
  await expect(sentence(page)).toContainText("multiplies Shuster/JPL (i*j = -k)");
  await expect(sentence(page)).toContainText("lets the left operand a of a*b act first");
  const relatives = page.getByRole("region", { name: "Between Hamilton and JPL" });
  await expect(relatives).toContainText("Not JPL: Shuster product, but R(q).");
  await expect(relatives).toContainText("row vectors");
  // And on to the last choice: the sheet says when there is nothing left to ask.
  await page.keyboard.type("0.52 0.52 0.47 0.47");
  await page.keyboard.press("Enter");
  await expect(page.locator(".left")).toHaveText("2 of 256 behaviours are left");
  await page.keyboard.type("0 0 0.71 0.71");
  await page.keyboard.press("Enter");
  await expect(page.locator(".left")).toHaveText("1 of 256 behaviours is left");
  await expect(page.locator(".no-question")).toContainText("all that numbers can tell is settled");
  await expect(sentence(page)).toBeFocused();
});

test("a small turn alone settles nothing of its axes and its sign; the quarter turn tells a formal sign", async ({
  page,
}) => {
  await startEmpty(page);
  await answer(page, "0 0 0 1", "3 1 2", "[[0, 0, 1], [1, 0, 0], [0, 1, 0]]");
  // Exp(φ) on the left of the numbers: the world's axes, or the body's with the formal sign.
  await page.keyboard.type("0.474 0.524 0.474 0.524");
  await page.keyboard.press("Enter");
  await expect(page.locator(".choices")).toContainText("0 of 3 settled");
  const axes = row(page, "Small rotation about the axes of");
  const sign = row(page, "Small rotation φ turns the body by");
  for (const choice of [axes, sign, row(page, "Body yawed")]) {
    await expect(choice.locator(".open")).toHaveCount(2);
  }
  await expect(sentence(page)).not.toContainText("small rotation");
  const follows = page.getByRole("region", { name: "Between Hamilton and JPL" });
  await expect(follows).toContainText(
    "The axes and the sign of a small rotation show only with a body turned by 90°.",
  );
  await expect(page.getByRole("heading", { name: "a body turned by 90°" })).toBeVisible();
  await page.keyboard.type("0.707 0 0 -0.707");
  await page.keyboard.press("Enter");
  await expect(page.locator(".left")).toHaveText("1 of 256 behaviours is left");
  await expect(axes.locator(".settled")).toContainText("the body");
  await expect(sign.locator(".settled")).toContainText("−φ, formal sign");
  await expect(sentence(page)).toContainText(
    "adds small rotations about the axes of the body with the formal sign (phi turns the body by -phi)",
  );
  await expect(follows).toContainText(
    "about the axes of the body turns the body by −φ, formal sign",
  );
  // Another small turn that disagrees does so about its sign alone.
  await page.getByRole("button", { name: /^a small rotation added/ }).click();
  await printed(page, 6).fill("0.524 0.474 0.524 0.474");
  await expect(page.locator(".contradiction")).toContainText(
    "Observations 4 and 6 cannot both be true: they disagree about the sign of a small rotation.",
  );
  await expect(page.locator(".claims tr")).toContainText(["−φ, formal sign", "φ, physical sign"]);
});

test("Enter makes a new line until nine numbers are there", async ({ page }) => {
  await page.goto("/#identify?probe=matrix;0.5+0.5+0.5+0.5;");
  await tabTo(page, printed(page, 1));
  for (const line of ["0 0 1", "1 0 0", "0 1 0"]) {
    await page.keyboard.type(line);
    await page.keyboard.press("Enter");
  }
  await expect(printed(page, 1)).toHaveValue("0 0 1\n1 0 0\n0 1 0");
  await expect(printed(page, 2)).toBeFocused();
});

test("q and −q, rounded or in single precision, are the same rotation", async ({ page }) => {
  for (const text of ["0.7071 0 0 0.7071", "-0.7071 0 0 -0.7071", "-0.70710677 0 0 -0.70710677"]) {
    await page.goto(`/#identify?name=X&probe=quarter-turn;${text.replaceAll(" ", "+")}`);
    await expect(row(page, "Body yawed").locator(".settled")).toContainText("z > 0");
    await expect(row(page, "Stores and prints").locator(".settled")).toContainText("w x y z");
  }
  await printed(page, 1).fill("0.71 0 0 0.71");
  await expect(row(page, "Body yawed").locator(".settled")).toContainText("z > 0");
  await printed(page, 1).fill("0 0 -0.70 0.72");
  await expect(row(page, "Body yawed").locator(".settled")).toContainText("z < 0");
  await expect(told(page, 1)).toContainText("Rounded");
});

test("a matrix of which nobody knows how it runs settles nothing, until it is told", async ({
  page,
}) => {
  await page.goto("/#identify?probe=matrix;0.5+0.5+0.5+0.5;0+0+1+1+0+0+0+1+0");
  const matrixRow = row(page, "Matrix of q");
  await expect(told(page, 1)).toContainText("Settles no choice by itself");
  await expect(matrixRow.locator(".settled")).toHaveCount(0);
  const layout = page.getByRole("combobox", { name: "observation 1 nine numbers" });
  await tabTo(page, layout);
  await page.keyboard.press("ArrowDown");
  await expect(matrixRow.locator(".settled")).toContainText("R(q)");
  await page.keyboard.press("ArrowDown");
  await expect(matrixRow.locator(".settled")).toContainText("C(q)");
  await expect(page).toHaveURL(/;columns/);
});

test("a contradiction shows the pair and loses nothing", async ({ page }) => {
  await startEmpty(page);
  await answer(page, "0 0 0 1", "3 1 2");
  await tabTo(page, page.getByRole("button", { name: /^a product/ }));
  await page.keyboard.press("Enter");
  const last = printed(page, 3);
  await expect(last).toBeFocused();
  await page.keyboard.type("0 0 0 -1");
  await expect(page.locator(".contradiction")).toContainText(
    "Observations 1 and 3 cannot both be true: they disagree about the product.",
  );
  await expect(page.locator(".contradicting")).toHaveCount(2);
  await expect(page.locator(".claims tr")).toContainText(["Hamilton", "Shuster"]);
  await expect(page.getByRole("status")).toContainText("Observations 1 and 3 contradict");
  // What was known before stands, marked as old; what was typed stays.
  await expect(
    page.getByText("Showing the last valid result, from before the contradiction."),
  ).toBeVisible();
  await expect(row(page, "Product").locator(".settled")).toContainText("Hamilton");
  await expect(last).toHaveValue("0 0 0 -1");
  await expect(last).toHaveAttribute("aria-invalid", "true");
  await typeOver(page, "0 0 0 1");
  await expect(page.locator(".contradiction")).toBeHidden();
  await expect(last).toHaveAttribute("aria-invalid", "false");
});

test("a text that cannot be read is marked in place and takes nothing away", async ({ page }) => {
  await page.goto("/#identify");
  const vector = printed(page, 2);
  await tabTo(page, vector);
  await page.keyboard.press("End");
  await page.keyboard.type(" oops");
  await expect(page.locator(".observation mark")).toHaveText("oops");
  await expect(vector).toHaveAccessibleDescription(/oops is not a known number, unit or function/);
  await expect(page.getByRole("status")).toContainText("Problem in observation 2: oops");
  await expect(
    page.getByText("Showing the last valid result, from before the change of observation 2."),
  ).toBeVisible();
  await expect(row(page, "Rotates a column by").locator(".settled")).toContainText("R(q)");
  for (const _ of " oops") await page.keyboard.press("Backspace");
  await expect(
    page.getByText("Showing the last valid result, from before the change of observation 2."),
  ).toBeHidden();
  await vector.fill("5 6 7");
  await expect(told(page, 2)).toContainText("No behaviour prints this");
});

test("what cannot be run is not asked, and can be asked again", async ({ page }) => {
  await startEmpty(page);
  const cannot = page.getByRole("button", { name: "I cannot run this" });
  await expect(page.getByRole("heading", { name: "a product" })).toBeVisible();
  await tabBackTo(page, cannot);
  await page.keyboard.press("Enter");
  await expect(page.getByRole("heading", { name: "a product" })).toBeHidden();
  await expect(printed(page, 1)).toBeFocused();
  await expect(page).toHaveURL(/unavailable=product/);
  for (let asked = 1; asked < 7; asked += 1) await cannot.click();
  await expect(page.locator(".no-question")).toContainText("None of the probes that you can run");
  await page.getByRole("button", { name: "Ask again" }).focus();
  await page.keyboard.press("Enter");
  await expect(page.getByRole("heading", { name: "a product" })).toBeVisible();
});

test("every probe can be added, changed and removed", async ({ page }) => {
  await startEmpty(page);
  const kinds = page.locator(".add button");
  for (const kind of await kinds.all()) await kind.click();
  await expect(page.locator(".observation")).toHaveCount(7);
  await page.getByRole("textbox", { name: "observation 1 a" }).fill("w:0 x:0 y:1 z:0");
  await printed(page, 1).fill("x: -1, y: 0, z: 0, w: 0");
  // Named numbers: j times k is i, in Hamilton; b stands as the constructor takes it.
  await expect(told(page, 1)).toContainText("Settles");
  const remove = page.getByRole("button", { name: /^Remove/ });
  await expect(remove).toHaveCount(7);
  for (let left = 7; left > 0; left -= 1) await remove.first().click();
  await expect(page.locator(".observation")).toHaveCount(1);
  await expect(page).toHaveURL(/#identify\?.*probe=(&|$)/);
});

test("the code of a question follows the language", async ({ page }) => {
  await page.goto("/#identify?name=&probe=");
  await expect(page.locator(".probe-code code")).toHaveText(/^print\(Quaternion/);
  await page.getByRole("combobox", { name: "Code in" }).selectOption("C++");
  await expect(page.locator(".probe-code code")).toHaveText(/^std::cout/);
  await expect(page).toHaveURL(/language=cpp/);
});

test("the field that is typed in stays where it is", async ({ page }) => {
  await startEmpty(page);
  const answers = ["-1 0 0 0", "3 1 2", "0 1 0 0 0 1 1 0 0", "0.52 0.52 0.47 0.47"];
  for (const [at, text] of answers.entries()) {
    const field = printed(page, at + 1);
    await field.focus();
    const top = () => field.evaluate((node) => node.getBoundingClientRect().top + scrollY);
    const before = await top();
    for (const character of text) {
      await page.keyboard.type(character);
      expect(await top()).toBe(before);
    }
  }
});

test("reloading the address gives the same sheet", async ({ page }) => {
  await startEmpty(page);
  await answer(page, "[1. 0. 0. 0.]", "3 1 2");
  await page.keyboard.type("[[0, 0, 1],\n");
  await page.getByRole("textbox", { name: "Library" }).fill("My & lib; ~1 #");
  await expect(page).toHaveURL(/name=My/);
  const before = await page.locator("main").innerHTML();
  await page.reload();
  await expect(printed(page, 3)).toHaveValue("[[0, 0, 1],\n");
  expect(await page.locator("main").innerHTML()).toEqual(before);
});

const states: Record<string, string> = {
  "the example": "identify",
  "an empty sheet": "identify?name=&probe=",
  "everything settled":
    "identify?probe=product;0+1+0+0;0+0+1+0;0+0+0+1&probe=rotate;0.5+0.5+0.5+0.5;1+2+3;3+1+2&probe=matrix;0.5+0.5+0.5+0.5;0+0+1+1+0+0+0+1+0&probe=perturb;0.5+0.5+0.5+0.5;0.1+0+0;0.473+0.523+0.523+0.473&probe=quarter-turn;0.7071+0+0+0.7071",
  "a contradiction":
    "identify?probe=product;0+1+0+0;0+0+1+0;0+0+0+1&probe=product;0+1+0+0;0+0+1+0;0+0+0+-1",
  "a problem and an unexplained one":
    "identify?unavailable=matrix&probe=rotate;0.5+0.5+0.5+0.5;1+2+3;3+1+oops&probe=matrix;0.5+0.5+0.5+0.5;1+2+3+4+5+6+7+8+9",
  "long texts": `identify?name=${"Long".repeat(60)}&probe=product;0.123456789012345678901+1+0+0;0+0+1+0;${"0.1234567890123456789+".repeat(4)}`,
};
for (const [name, fragment] of Object.entries(states)) {
  for (const colorScheme of ["light", "dark"] as const) {
    test(`no accessibility violation: ${colorScheme}, ${name}`, async ({ page }) => {
      await page.emulateMedia({ colorScheme });
      await page.goto(`/#${fragment}`);
      await expect(page.locator(".choices")).toBeVisible();
      expect(await violationsOf(page)).toEqual([]);
    });
  }

  test(`nothing is wider than a phone: ${name}`, async ({ page }) => {
    await page.setViewportSize({ width: 320, height: 740 });
    await page.goto(`/#${fragment}`);
    await expect(page.locator(".choices")).toBeVisible();
    await openEverything(page);
    expect(await sidewaysScroll(page)).toBeLessThanOrEqual(0);
  });
}

for (const fragment of [
  "probe=product;<script>alert(1)</script>;%00;%F0%9F%99%82",
  `probe=matrix;${"(".repeat(500)};${"9".repeat(5000)};sideways`,
  `${"probe=product;0+1+0+0;0+0+1+0;0+0+0+1&".repeat(500)}probe=rotate`,
  "probe=perturb;1+0+0+0;1e308+1e308+1e308;1+0+0+0&probe=rotate;1e-320+0+0+0;0+0+0;0+0+0",
  "name=%E0%A4%A&language=klingon&unavailable=__proto__,rotate&probe=constructor;1",
]) {
  test(`a hostile address opens: ${fragment.slice(0, 40)}`, async ({ page }) => {
    await page.goto(`/#identify?${fragment}`);
    await expect(page.locator(".choices")).toBeVisible();
    await expect(page.locator(".failure")).toBeHidden();
    await expect(page.getByText(/NaN|undefined/)).toHaveCount(0);
  });
}
