// The page before its program: the opening example stands in the HTML, and nothing done with it is lost.
import { type Page, test as unwatched } from "@playwright/test";
import {
  expect,
  haveNoLetters,
  holdBack,
  matrix,
  numbersOf,
  quaternionField,
  started,
  tab,
  test,
} from "./support/page.ts";

const example = [0.707107, -0.707107, 0, 0.707107, 0.707107, 0, 0, 0, 1];
const quarterTurn = [0, -1, 0, 1, 0, 0, 0, 0, 1];

/** Opens an address whose program does not come until it is let. */
async function openWithoutProgram(page: Page, address: string) {
  const allow = await holdBack(page, "**/index-*.js");
  await page.goto(address, { waitUntil: "commit" });
  await page.waitForFunction(() => document.querySelector("#page footer")?.checkVisibility());
  return async () => {
    allow();
    await started(page);
  };
}

/** The texts of the page that can be seen, those of fields too. */
const seenTexts = (page: Page) =>
  page.evaluate(() => {
    const elements = [...document.querySelectorAll<HTMLElement>("body *")].filter(
      (element) =>
        element.checkVisibility({ visibilityProperty: true, opacityProperty: true }) &&
        element.closest(".visually-hidden, svg, script, noscript") === null,
    );
    return elements.flatMap((element) => [
      ...(element instanceof HTMLInputElement || element instanceof HTMLTextAreaElement
        ? [element.value]
        : []),
      ...[...element.childNodes]
        .filter((node) => node.nodeType === Node.TEXT_NODE)
        .map((node) => node.textContent?.trim() ?? ""),
    ]);
  });

unwatched(
  "without scripts the page shows the example whole, and what scripts add",
  async ({ browser, baseURL }) => {
    const context = await browser.newContext({ javaScriptEnabled: false });
    const page = await context.newPage();
    await page.goto(baseURL ?? "");
    await expect(page.locator("noscript p")).toContainText("With JavaScript and WebAssembly");
    await expect(page.getByText("Loading the playground")).toBeHidden();
    await expect(page.getByText("could not start")).toBeHidden();
    await expect(quaternionField(page)).toHaveValue("cos(pi/8) + sin(pi/8) k");
    for (const name of ["R(q)", "C(q)", "inverse of R(q)", "inverse of C(q)"]) {
      await expect(matrix(page, name)).toBeVisible();
    }
    expect(await numbersOf(matrix(page, "R(q)"))).toEqual(example);
    await expect(page.getByRole("button")).toHaveCount(0);
    await context.close();
  },
);

test("the page is that of the program: nothing is replaced, and nothing differs", async ({
  page,
}) => {
  const start = await openWithoutProgram(page, "/");
  const nodes = await page.evaluateHandle(() => [...document.querySelectorAll("#page *")]);
  expect(await numbersOf(matrix(page, "R(q)"))).toEqual(example);
  await start();
  const [kept, all] = await nodes.evaluate((nodes) => [
    // What says that a part is still to come goes when it is there, and then has no parent.
    nodes.filter(
      (node) =>
        node.isConnected || node.closest(".picture, .more, .folds, .fold-wait, .picture-wait"),
    ).length,
    nodes.length,
  ]);
  expect(all).toBeGreaterThan(500);
  expect(kept).toBe(all);
  const html = await settled(page);

  // The same, rendered by the program alone.
  await page.unrouteAll();
  await page.route("/", async (route) => {
    const answer = await route.fetch();
    const body = (await answer.text()).replace(
      /<div id="page">[\s\S]*<\/div>(?=\s*<\/body>)/,
      '<div id="page"></div>',
    );
    await route.fulfill({ response: answer, body });
  });
  await page.goto("/");
  const anew = await settled(page);
  expect(anew.length).toBeGreaterThan(500);
  expect(html).toEqual(anew);
});

/** The elements of the page with their attributes, once all that follows the first result is there. */
async function settled(page: Page) {
  await expect(page.locator(".fold-wait, .picture-wait")).toHaveCount(0);
  await expect(page).toHaveTitle(/·|45°/);
  return page.evaluate(() =>
    [...document.querySelectorAll("#page *")].map((element) => {
      const attributes = [...element.attributes]
        // What HTML says of a field at first a program says as its value.
        .filter(({ name }) => !["value", "checked", "selected", "style"].includes(name))
        // Ids are given in the order in which parts come.
        .map(({ name, value }) => `${name}=${value.replace(/^P\d+-\d+$/, "P")}`);
      const field = element as HTMLInputElement;
      const own = [...element.childNodes]
        .filter((node) => node.nodeType === Node.TEXT_NODE && element.tagName !== "TEXTAREA")
        .map((node) => node.textContent);
      return [element.tagName, ...attributes.sort(), field.value, field.checked, own.join("")].join(
        " ",
      );
    }),
  );
}

test("no element of the HTML has a style of its own, which the policy would refuse", async ({
  page,
}) => {
  const html = await (await page.request.get("/")).text();
  expect(html).toContain("0.707107");
  expect(html).not.toMatch(/<[^>]+\sstyle=/);
});

test("what is typed before the program is there is answered when it comes", async ({ page }) => {
  const start = await openWithoutProgram(page, "/");
  await quaternionField(page).focus();
  await page.keyboard.press("ControlOrMeta+a");
  await page.keyboard.type("90deg about y");
  await page.keyboard.press("Backspace");
  await page.keyboard.type("z");
  for (const _ of "about z") await page.keyboard.press("ArrowLeft");
  // The numbers are still those of the example, and look it.
  await expect(page.getByText("Loading the playground")).toBeVisible();
  const filter = page.locator(".result > *").first();
  await expect(filter).toHaveCSS("filter", "grayscale(1)");
  await start();
  await expect(quaternionField(page)).toHaveValue("90deg about z");
  await expect.poll(() => numbersOf(matrix(page, "R(q)"))).toEqual(quarterTurn);
  await expect(filter).toHaveCSS("filter", "none");
  await expect(quaternionField(page)).toBeFocused();
  // Where the cursor was.
  await page.keyboard.type("0*");
  await expect(quaternionField(page)).toHaveValue("90deg 0*about z");
});

test("what is chosen, edited and pressed before the program is there is done when it comes", async ({
  page,
}) => {
  const start = await openWithoutProgram(page, "/");
  await page.getByRole("radio", { name: /^JPL/ }).first().check();
  await page.getByLabel("Euler axes").selectOption("x-y-z");
  await page.getByRole("button", { name: "Keyboard shortcuts" }).click();
  await start();
  await expect(page.getByRole("radio", { name: /^JPL/ }).first()).toBeChecked();
  await expect(page).toHaveURL(/as=jpl/);
  await expect(page).toHaveURL(/euler=/);
  await expect(page.getByRole("dialog")).toContainText("Keyboard shortcuts");
});

test("what is edited before the program is there is done in its order when it comes", async ({
  page,
}) => {
  const start = await openWithoutProgram(page, "/");
  await page.getByRole("textbox", { name: "angle in degrees" }).fill("80");
  await page.getByRole("textbox", { name: "axis, z" }).fill("-1");
  await page.getByRole("textbox", { name: "angle in degrees" }).fill("90");
  await start();
  const turnedBack = [0, 1, 0, -1, 0, 0, 0, 0, 1];
  await expect.poll(() => numbersOf(matrix(page, "R(q)"))).toEqual(turnedBack);
  await expect(quaternionField(page)).toHaveValue("90° about [0, 0, -1]");
});

test("what is pressed before the program is there has the answer to what was typed", async ({
  page,
  context,
}) => {
  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  const start = await openWithoutProgram(page, "/");
  // What only the whole core reads.
  await quaternionField(page).fill("Rotation.from_quat([0, 0, 0.6, 0.8])");
  await page.getByRole("button", { name: "Copy Hamilton q", exact: true }).click();
  await start();
  await expect(page.getByRole("status")).toContainText("Hamilton q copied");
  expect(await page.evaluate(() => navigator.clipboard.readText())).toBe("[0.8, 0, 0, 0.6]");
});

test("a view that is opened after something was typed leaves it in the history", async ({
  page,
}) => {
  const start = await openWithoutProgram(page, "/");
  await quaternionField(page).fill("90deg about z");
  await tab(page, "Compose").click();
  await start();
  await expect(matrix(page, "R(p ⊙ q)")).toBeVisible();
  await page.goBack();
  await expect(quaternionField(page)).toHaveValue("90deg about z");
  await expect.poll(() => numbersOf(matrix(page, "R(q)"))).toEqual(quarterTurn);
});

test("a text that is being composed when the program comes stays whole", async ({ page }) => {
  const start = await openWithoutProgram(page, "/");
  await quaternionField(page).fill("");
  await quaternionField(page).focus();
  const session = await page.context().newCDPSession(page);
  const composing = { selectionStart: 5, selectionEnd: 5, text: "0 1 0" };
  await session.send("Input.imeSetComposition", composing);
  const started = start();
  await page.waitForFunction(() =>
    performance.getEntriesByType("resource").some(({ name }) => /index-/.test(name)),
  );
  await session.send("Input.insertText", { text: "0 1 0 0" });
  await started;
  await expect(quaternionField(page)).toHaveValue("0 1 0 0");
});

unwatched("what was typed survives a program that does not arrive", async ({ page }) => {
  await page.route("**/index-*.js", (route) => route.abort());
  await page.goto("/");
  await quaternionField(page).fill("90deg about z");
  await page.unroute("**/index-*.js");
  await page.getByRole("alert").getByRole("button", { name: "Try again" }).click();
  await started(page);
  await expect(quaternionField(page)).toHaveValue("90deg about z");
  await expect.poll(() => numbersOf(matrix(page, "R(q)"))).toEqual(quarterTurn);
});

test("what is opened before the program is there stays open", async ({ page }) => {
  const start = await openWithoutProgram(page, "/");
  await page.getByText("What each convention multiplies").click();
  await start();
  await expect(page.locator(".folds details").first()).toHaveAttribute("open");
  await expect(page.locator(".folds .rules").first()).toBeVisible();
});

for (const [address, current] of [
  ["/#read?as=jpl&quaternion=0+0+0.6+0.8", "Read"],
  ["/#read?digits=4", "Read"],
  ["/#compose", "Compose"],
  ["/#translate", "Libraries"],
  ["/#libraries?find=eigen", "Libraries"],
] as const) {
  test(`a link shows its frame, and nothing of the example: ${address}`, async ({ page }) => {
    const start = await openWithoutProgram(page, address);
    const texts = (await seenTexts(page)).filter((text) => text !== "");
    expect(texts.filter((text) => /\d|pi|√|Euler|declared/.test(text))).toEqual([]);
    expect(texts).toContain("quatlas");
    expect(texts).toContain("Loading the playground …");
    const bold = await page
      .locator(".views a")
      .evaluateAll((links) =>
        links
          .filter((link) => getComputedStyle(link).fontWeight === "600")
          .map((link) => link.textContent),
      );
    expect(bold).toEqual([current]);
    await start();
    await expect(tab(page, current)).toHaveAttribute("aria-current", "page");
    await expect(page.getByText("Loading the playground")).toHaveCount(0);
  });
}

test("another view is opened before the program is there", async ({ page }) => {
  const start = await openWithoutProgram(page, "/");
  await tab(page, "Compose").click();
  await expect
    .poll(async () => (await seenTexts(page)).filter((text) => /\d/.test(text)))
    .toEqual([]);
  await start();
  await expect(matrix(page, "R(p ⊙ q)")).toBeVisible();
});

test("remembered decimals and units never show as a change of numbers", async ({ page }) => {
  for (const [setting, chosen] of [
    ["digits", "4"],
    ["unit", "radians"],
  ] as const) {
    await page.goto("/");
    await page.evaluate(([setting, chosen]) => localStorage.setItem(`quatlas-${setting}`, chosen), [
      setting,
      chosen,
    ] as const);
    const start = await openWithoutProgram(page, "/");
    expect((await seenTexts(page)).filter((text) => /\d/.test(text))).toEqual([]);
    await start();
    await expect(quaternionField(page)).toBeVisible();
    await page.evaluate(() => localStorage.clear());
    await page.unrouteAll();
    await page.goto("about:blank");
  }
});

test("a remembered theme and format are those of the page, and the numbers stand there", async ({
  page,
}) => {
  await page.goto("/");
  await page.evaluate(() => {
    localStorage.setItem("quatlas-theme", "dark");
    localStorage.setItem("quatlas.copy-format", "eigen");
  });
  const start = await openWithoutProgram(page, "/");
  expect(await numbersOf(matrix(page, "R(q)"))).toEqual(example);
  await expect(page.locator(".copy-line").first()).toHaveCSS("visibility", "hidden");
  await expect(page.locator("html")).toHaveAttribute("data-theme", "dark");
  await quaternionField(page).fill("90deg about z");
  await start();
  await expect.poll(() => numbersOf(matrix(page, "R(q)"))).toEqual(quarterTurn);
  await expect(page.getByRole("button", { name: "Theme: dark" })).toBeVisible();
  await expect(page.getByRole("button", { name: "Copy R(q) as C++, Eigen" })).toBeVisible();
});

test("the core is asked for before the program is there, once, and the right one", async ({
  page,
}) => {
  const cores: string[] = [];
  page.on("request", (request) => {
    const core = /quatlas_(?:small_)?bg/.exec(request.url());
    if (core) cores.push(core[0]);
  });
  for (const [address, core] of [
    ["/", "quatlas_small_bg"],
    ["/#compose", "quatlas_small_bg"],
    ["/#translate", "quatlas_bg"],
  ] as const) {
    cores.length = 0;
    await page.goto("about:blank");
    const start = await openWithoutProgram(page, address);
    await expect.poll(() => cores).toEqual([core]);
    await start();
    await page.waitForLoadState("networkidle");
    expect(cores).toEqual([core]);
    await page.unrouteAll();
  }
});

/** The files of letters that a page asks for, as it does. */
function lettersAskedBy(page: Page): string[] {
  const asked: string[] = [];
  page.on("request", (request) => {
    if (request.url().endsWith(".woff2")) asked.push(request.url());
  });
  return asked;
}

/** Whether those of the page are there, each face. */
const faces = (page: Page) =>
  page.evaluate(() =>
    [...document.fonts]
      .filter(({ family }) => family.includes("Plex"))
      .map(({ status }) => status)
      .join(" "),
  );

test("the letters come after the result where the line is slow", async ({ page }) => {
  await haveNoLetters(page);
  const asked = lettersAskedBy(page);
  const start = await openWithoutProgram(page, "/");
  expect(await numbersOf(matrix(page, "R(q)"))).toEqual(example);
  expect(asked).toEqual([]);
  await start();
  await page.waitForFunction(() => localStorage.getItem("quatlas-letters") === "kept");
  expect(asked).toHaveLength(4);
  // They would move what is read already.
  expect(await faces(page)).toBe("");
});

test("the letters are there with the numbers where the browser has them", async ({ page }) => {
  await page.goto("/");
  await expect(page.locator("html")).not.toHaveAttribute("data-letters");
  expect(await faces(page)).toBe("loaded loaded loaded loaded");
});

unwatched(
  "the letters are asked for at once where the page was answered at once",
  async ({ page }) => {
    await page.addInitScript(() => {
      Object.defineProperty(PerformanceNavigationTiming.prototype, "requestStart", {
        get: () => performance.now() - 20,
      });
    });
    const asked = lettersAskedBy(page);
    const start = await openWithoutProgram(page, "/");
    await expect.poll(() => asked).toHaveLength(4);
    await start();
  },
);

unwatched("a core that does not come leaves the example, and what was typed", async ({ page }) => {
  await page.route("**/quatlas_small_bg-*.wasm", (route) => route.abort());
  await page.goto("/");
  await quaternionField(page).fill("90deg about z");
  await expect(page.getByRole("alert")).toContainText("The core could not be loaded");
  await expect(quaternionField(page)).toHaveValue("90deg about z");
  expect(await numbersOf(matrix(page, "R(q)"))).toEqual(example);
  await page.unroute("**/quatlas_small_bg-*.wasm");
  await page.getByRole("alert").getByRole("button", { name: "Try again" }).click();
  await expect.poll(() => numbersOf(matrix(page, "R(q)"))).toEqual(quarterTurn);
});
