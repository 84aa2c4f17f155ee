// The table of libraries, by keyboard.
import {
  expect,
  openEverything,
  sidewaysScroll,
  tabTo,
  test,
  typeOver,
  violationsOf,
} from "./support/page.ts";

test("opens on the whole table, with how each record is known", async ({ page }) => {
  await page.goto("/#libraries");
  await expect(page.locator(".library-row").first()).toBeVisible();
  expect(await page.locator(".library-row").count()).toBeGreaterThanOrEqual(60);
  const row = page.getByRole("row", { name: /^DirectXMath/ });
  // Shuster's product and R(q): not JPL, and the left operand acts first.
  await expect(row.getByRole("cell")).toHaveText([
    /^321/,
    "run",
    "x y z w",
    "x y z w",
    "ij = −k",
    "R(q)",
    "C(q), v M",
    "a",
    "not JPL: Shuster product, but R(q)",
  ]);
  const message = page.getByRole("row", { name: /^ROS geometry_msgs/ });
  await expect(message.getByRole("cell").nth(1)).toHaveText("documented");
  await expect(message.getByRole("cell").nth(3)).toContainText("not established");
});

test("is searched by typing, and said", async ({ page }) => {
  await page.goto("/#libraries");
  await tabTo(page, page.getByRole("searchbox", { name: "Find a library" }));
  await page.keyboard.type("rust graphics");
  await expect(page.locator(".library-row th")).toHaveText([
    "glam DQuat",
    "cgmath",
    "quaternion (Piston)",
  ]);
  await expect(page).toHaveURL(/libraries\?v=1&find=rust\+graphics/);
  await expect(page.getByRole("status")).toHaveText(/^3 of \d+ libraries\.$/);
  await typeOver(page, "nothing at all");
  await page.getByRole("button", { name: /^show all/ }).click();
  await expect(page.getByRole("searchbox")).toHaveValue("");
});

test("a record is opened by keyboard, and its numbers are loaded only then", async ({ page }) => {
  const loaded: string[] = [];
  page.on("request", (request) => loaded.push(request.url()));
  await page.goto("/#libraries?find=directxmath");
  const link = page.getByRole("link", { name: "DirectXMath" });
  await tabTo(page, link);
  expect(loaded.filter((url) => url.includes("observations"))).toEqual([]);
  await page.keyboard.press("Enter");
  await expect(link).toHaveAttribute("aria-expanded", "true");
  await expect(page).toHaveURL(/library=directxmath/);
  const record = page.getByRole("article", { name: "The record of DirectXMath" });
  await expect(record).toContainText("XMVECTOR q = XMVectorSet(x, y, z, w);");
  await expect(record).toContainText("It was run");
  await record.getByText("What it printed").click();
  // i * j = −k, as w x y z.
  const product = record.locator(".record-fact", { has: page.getByText("i * j", { exact: true }) });
  await expect(product.locator("pre")).toHaveText("[0, 0, 0, −1]");
  expect(loaded.filter((url) => url.includes("observations"))).toHaveLength(1);
  await page.goBack();
  await expect(record).toBeHidden();
});

test("an address opens its record and brings it into view", async ({ page }) => {
  await page.goto("/#libraries?library=joml");
  const row = page.locator("#library-joml");
  await expect(row).toBeInViewport();
  const record = page.getByRole("article", { name: "The record of JOML Quaterniond" });
  await expect(record).toContainText("source read");
  await expect(record.getByText("What it printed")).toHaveCount(0);
});

test("a record leads to its translation and back", async ({ page }) => {
  await page.goto("/#libraries?library=basilisk");
  await page.getByRole("link", { name: "Translate from" }).click();
  await expect(page.getByRole("combobox", { name: "From", exact: true })).toHaveValue("Basilisk");
  await page.getByRole("link", { name: "its record" }).last().click();
  await expect(page.getByRole("article", { name: "The record of Ceres" })).toBeVisible();
});

test("every record can be opened", async ({ page }) => {
  await page.goto("/#libraries");
  await expect(page.locator(".library-row").first()).toBeVisible();
  const links = await page.locator(".library-row a").all();
  const hrefs = await Promise.all(links.map((link) => link.getAttribute("href")));
  for (const href of hrefs) {
    await page.evaluate((address) => {
      location.hash = address;
    }, href ?? "");
    await expect(page.locator(".record")).toBeVisible();
    const text = await page.locator(".record").innerText();
    expect(text).not.toMatch(/undefined|null\b|\{[wxyz]\}|\[object/);
  }
});

test("hostile addresses give the table", async ({ page }) => {
  for (const hostile of ["library=__proto__", "library=%00&find=%E0%A4%A", "find=(((&library="]) {
    await page.goto(`/#libraries?${hostile}`);
    await expect(page.getByRole("searchbox")).toBeVisible();
    await expect(page.locator(".record")).toHaveCount(0);
  }
});

for (const colorScheme of ["light", "dark"] as const) {
  test(`no accessibility violation with a record open: ${colorScheme}`, async ({ page }) => {
    await page.emulateMedia({ colorScheme });
    await page.goto("/#libraries?library=maplab&find=jpl");
    await expect(page.locator(".record")).toBeVisible();
    await openEverything(page);
    await expect(page.locator(".printed")).toBeVisible();
    expect(await violationsOf(page)).toEqual([]);
  });
}

for (const width of [320, 768, 990, 1280]) {
  test(`no sideways scroll at ${width} px with a record open`, async ({ page }) => {
    await page.setViewportSize({ width, height: 740 });
    for (const id of ["eigen", "anise", "cesium", "matlab-aerospace"]) {
      await page.goto(`/#libraries?library=${id}`);
      await expect(page.locator(".record")).toBeVisible();
      await openEverything(page);
      expect(await sidewaysScroll(page)).toBeLessThanOrEqual(0);
    }
  });
}
