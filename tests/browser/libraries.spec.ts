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

test("formats and devices are found by what people call them, and say what they are", async ({
  page,
}) => {
  await page.goto("/#libraries");
  const find = page.getByRole("searchbox", { name: "Find a library" });
  const rows = page.locator(".library-row th");
  for (const [typed, name] of [
    ["tum", "TUM RGB-D trajectoryformat"],
    ["images.txt", "COLMAP images.txtformat"],
    ["kuka", "KUKA A, B, Cdevice"],
    ["xsens", "Xsens MTidevice"],
    ["solvePnP", "OpenCV rvec, tveclibrary"],
    ["urscript", "Universal Robots Rx, Ry, Rzdevice"],
  ] as const) {
    await find.fill(typed);
    await expect(rows.first()).toHaveText(name);
  }
  await find.fill("left-handed");
  await expect(rows).toHaveText([
    "Unity.Mathematics quaternion",
    "Unity Quaternion",
    "Unreal Engine FQuat",
    "CARLA Rotationlibrary",
  ]);
});

test("a record without a quaternion says what it writes, and what is not certain", async ({
  page,
}) => {
  await page.goto("/#libraries?library=staubli-rxryrz");
  const row = page.getByRole("row", { name: /^Stäubli/ });
  await expect(row.getByRole("cell")).toHaveText([
    "third parties",
    "documented",
    "rx ry rz in degrees",
    "Rx(rx) Ry(ry) Rz(rz)",
    /not established/,
    "",
    "Euler angles",
  ]);
  const record = page.getByRole("article", { name: /^The record of Stäubli/ });
  await expect(record).toContainText("Not certain: An answer in a forum has the other order.");
  // Of a controller nothing is asked that only calls of a library answer.
  await expect(record.getByText("slerp")).toHaveCount(0);
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

test("the list is one stop of the Tab key: arrows lead through it, Enter opens", async ({
  page,
}) => {
  await page.goto("/#libraries?find=rust");
  const links = page.locator(".library-row a");
  await tabTo(page, page.getByRole("searchbox"));
  // From the search straight to the list.
  await page.keyboard.press("ArrowDown");
  const count = await links.count();
  expect(count).toBeGreaterThan(4);
  for (let at = 0; at < count; at += 1) {
    await expect(links.nth(at)).toBeFocused();
    await page.keyboard.press("ArrowDown");
  }
  await expect(links.last()).toBeFocused();
  await page.keyboard.press("Home");
  await expect(links.first()).toBeFocused();
  await page.keyboard.press("End");
  await page.keyboard.press("ArrowUp");
  await page.keyboard.press("Enter");
  const opened = links.nth(count - 2);
  await expect(opened).toHaveAttribute("aria-expanded", "true");
  await expect(opened).toBeFocused();
  // Its links follow, then what stands below the list; back again leads to the library.
  await page.keyboard.press("Tab");
  await expect(page.getByRole("link", { name: "Translate from" })).toBeFocused();
  await page.keyboard.press("Shift+Tab");
  await expect(opened).toBeFocused();
  await page.keyboard.press("Enter");
  await expect(page.locator(".record")).toHaveCount(0);
  await page.keyboard.press("Tab");
  await expect(page.locator(".libraries :focus")).toHaveCount(0);
  // Where the library is not found any more, the Tab key reaches the first one that is.
  await page.getByRole("searchbox").fill("minkindr");
  await expect(links).toHaveText(["minkindr"]);
  await expect(links).toHaveAttribute("tabindex", "0");
});

test("a group is gone to", async ({ page }) => {
  await page.goto("/#libraries");
  await page.getByRole("button", { name: "Mathematics" }).click();
  await expect(page.getByRole("heading", { name: "Mathematics" })).toBeInViewport({ ratio: 1 });
  const group = page.locator("tbody", { has: page.locator("h2", { hasText: "Mathematics" }) });
  await expect(group.getByRole("link").first()).toBeFocused();
  await page.getByRole("searchbox").fill("openvins");
  await expect(page.getByRole("button", { name: "Estimation" })).toBeEnabled();
  await expect(page.getByRole("button", { name: "Mathematics" })).toBeDisabled();
});

for (const width of [320, 360, 390, 768]) {
  test(`a library is one line at ${width} px, and opens where it is tapped`, async ({ page }) => {
    await page.setViewportSize({ width, height: 844 });
    await page.goto("/#libraries");
    await expect(page.locator(".library-row").first()).toBeVisible();
    const rows = await page.locator(".library-row").evaluateAll((found) =>
      found.map((row) => ({
        name: row.querySelector("th")?.textContent,
        height: row.getBoundingClientRect().height,
        cells: [...row.querySelectorAll("td")].filter((cell) => cell.checkVisibility()).length,
        beyond: row.scrollWidth - row.clientWidth,
      })),
    );
    expect(rows.length).toBeGreaterThanOrEqual(60);
    for (const { name, height, cells, beyond } of rows) {
      expect(height, `${name}`).toBeGreaterThanOrEqual(36);
      expect(height, `${name}`).toBeLessThan(44);
      expect(cells, `${name}`).toBeGreaterThanOrEqual(3);
      expect(beyond, `${name}`).toBeLessThanOrEqual(0);
    }
    // As cards 97 of them took 18 317 px at 390 px; this much and the groups is what lines take.
    const most = rows.length * 42 + 900;
    expect(await page.evaluate(() => document.body.scrollHeight)).toBeLessThan(most);
    const row = page.locator("#library-eigen");
    await expect(row.locator("td:visible").first()).toHaveText("x y z w");
    await expect(row.locator("strong:visible")).toHaveText("w x y z");
    // Anywhere on the line.
    await row.click({ position: { x: width - 60, y: 10 } });
    await expect(row.locator("td:visible")).toHaveCount(9);
    await expect(page.getByRole("article", { name: /^The record of Eigen/ })).toBeVisible();
    expect(await sidewaysScroll(page)).toBeLessThanOrEqual(0);
  });
}

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

for (const third of [0, 1, 2]) {
  test(`every record can be opened, third ${third + 1} of 3`, async ({ page }) => {
    await page.goto("/#libraries");
    await expect(page.locator(".library-row").first()).toBeVisible();
    const hrefs = await page
      .locator(".library-row a")
      .evaluateAll((links) => links.map((link) => link.getAttribute("href")));
    expect(hrefs.length).toBeGreaterThan(160);
    for (const href of hrefs.filter((_, at) => at % 3 === third)) {
      await page.evaluate((address) => {
        location.hash = address;
      }, href ?? "");
      await expect(page.locator(".record")).toBeVisible();
      const text = await page.locator(".record").innerText();
      expect(text).not.toMatch(/undefined|null\b|\{[wxyz]\}|\[object/);
    }
  });
}

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
