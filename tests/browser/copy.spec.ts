// The copy button and its menu of formats.
import type { Page } from "@playwright/test";
import { expect, matrix, quaternionField, test, violationsIn } from "./support/page.ts";

test.beforeEach(({ context }) => context.grantPermissions(["clipboard-read", "clipboard-write"]));

const jplLog = "/#read?as=jpl&quaternion=0.1+-0.2+0.4+0.888819441731559";
const clipboard = (page: Page) => page.evaluate(() => navigator.clipboard.readText());
const menuOf = (page: Page, of: string) =>
  page.getByRole("button", { name: `Formats of ${of}`, exact: true });
const item = (page: Page, name: string) => page.getByRole("menuitemradio", { name, exact: true });
const focused = (page: Page) =>
  page.evaluate(() => document.activeElement?.getAttribute("aria-label"));

test("a value is copied as code, and the next click copies that format", async ({ page }) => {
  await page.goto(jplLog);
  await menuOf(page, "JPL q").click();
  await expect(page.getByRole("menu", { name: "Copy JPL q as" })).toBeVisible();
  await expect(item(page, "Numbers")).toHaveAttribute("aria-checked", "true");
  await expect(item(page, "Python, SciPy")).toContainText("q = Rotation.from_quat([0.1, -0.2");
  await item(page, "Python, SciPy").click();
  await expect(page.getByText("JPL q copied as Python, SciPy", { exact: true })).toBeVisible();
  await expect(page.getByRole("menu")).toHaveCount(0);
  const text = await clipboard(page);
  expect(text).toContain("# q: JPL (ij = -k), world to body; from_quat takes x y z w\n");
  expect(text).toMatch(/\nq = Rotation\.from_quat\(\[0\.1, -0\.2, 0\.4, 0\.888819441731559\]\)$/);

  await page.getByRole("button", { name: "Copy C(q) as Python, SciPy", exact: true }).click();
  await expect.poll(() => clipboard(page)).toContain("Rotation.from_matrix([[0.6");
  // A vector has no such format: its numbers are copied, and the button says no more than that.
  await page.getByRole("button", { name: "Copy C(q) v", exact: true }).click();
  await expect.poll(() => clipboard(page)).toMatch(/^\[.*\]$/);

  await page.reload();
  await expect(
    page.getByRole("button", { name: "Copy JPL q as Python, SciPy", exact: true }),
  ).toBeVisible();
  await menuOf(page, "JPL q").click();
  await item(page, "Numbers").click();
  await expect.poll(() => clipboard(page)).toBe("[0.1, -0.2, 0.4, 0.888819441731559]");
});

test("a JPL log becomes code for Eigen in four actions", async ({ page }) => {
  await page.goto("/");
  await expect(matrix(page, "R(q)")).toBeVisible();
  await page.evaluate(() => navigator.clipboard.writeText("-0.0212 0.7031 0.0148 0.7106\n"));
  // 1: pasted without a click into the field.
  await page.keyboard.press("ControlOrMeta+v");
  await expect(quaternionField(page)).toHaveValue("-0.0212 0.7031 0.0148 0.7106");
  await expect(quaternionField(page)).toBeFocused();
  // 2
  await page.getByRole("radio", { name: /^JPL/ }).first().check();
  // 3, 4
  await menuOf(page, "Hamilton q").click();
  await item(page, "C++, Eigen").click();
  await expect
    .poll(() => clipboard(page))
    .toContain("Eigen::Quaterniond q(0.7106, -0.0212, 0.7031, 0.0148);");

  // One step of undoing, also where a choice has the focus; a field takes what is pasted by itself.
  await page.evaluate(() => navigator.clipboard.writeText("1 2 3 4"));
  await page.getByRole("radio", { name: /^JPL/ }).first().focus();
  await page.keyboard.press("ControlOrMeta+v");
  await expect(quaternionField(page)).toHaveValue("1 2 3 4");
  await page.getByRole("button", { name: "Undo" }).click();
  await expect(quaternionField(page)).toHaveValue("-0.0212 0.7031 0.0148 0.7106");
  const vector = page.getByRole("textbox", { name: "vector v" });
  await vector.selectText();
  await page.keyboard.press("ControlOrMeta+v");
  await expect(vector).toHaveValue("1 2 3 4");
  await expect(quaternionField(page)).toHaveValue("-0.0212 0.7031 0.0148 0.7106");
});

test("the menu is used by keyboard alone", async ({ page }) => {
  await page.goto(jplLog);
  await page.getByRole("button", { name: "Copy Hamilton q", exact: true }).focus();
  await page.keyboard.press("ArrowDown");
  const names = ["Numbers", "C++, Eigen", "Python, SciPy", "Python, NumPy", "ROS YAML"];
  for (const name of names) {
    await expect.poll(() => focused(page)).toBe(name);
    await page.keyboard.press("ArrowDown");
  }
  await page.keyboard.press("End");
  expect(await focused(page)).toBe("Test vector");
  await page.keyboard.press("ArrowDown");
  expect(await focused(page)).toBe("Numbers");
  await page.keyboard.press("ArrowUp");
  expect(await focused(page)).toBe("Test vector");
  await page.keyboard.press("Home");
  expect(await focused(page)).toBe("Numbers");
  await page.keyboard.type("ma");
  expect(await focused(page)).toBe("MATLAB");
  await page.keyboard.press("Escape");
  await expect(page.getByRole("menu")).toHaveCount(0);
  expect(await focused(page)).toBe("Copy Hamilton q");
  await page.keyboard.press("ArrowUp");
  await expect.poll(() => focused(page)).toBe("Numbers");
  await page.keyboard.press("r");
  expect(await focused(page)).toBe("ROS YAML");
  await page.keyboard.press("Enter");
  await expect
    .poll(() => clipboard(page))
    .toMatch(/^# q: Hamilton .*\nx: 0\.1\ny: -0\.2\nz: 0\.4\nw: 0\.888819441731559$/);
  expect(await focused(page)).toBe("Copy Hamilton q as ROS YAML");
  await page.keyboard.press("ArrowUp");
  await expect.poll(() => focused(page)).toBe("ROS YAML");
  await page.keyboard.press("Tab");
  await expect(page.getByRole("menu")).toHaveCount(0);
});

test("a format that cannot say a value is not offered", async ({ page }) => {
  await page.goto(jplLog);
  const offered = async (of: string) => {
    await menuOf(page, of).click();
    await expect(item(page, "Numbers")).toBeVisible();
    const names = await page
      .getByRole("menuitemradio")
      .evaluateAll((items) => items.map((item) => item.getAttribute("aria-label")));
    await page.keyboard.press("Escape");
    await expect(page.getByRole("menu")).toHaveCount(0);
    return names;
  };
  expect(await offered("Hamilton q")).toHaveLength(12);
  expect(await offered("R(q)")).not.toContain("ROS YAML");
  expect(await offered("R(q) v")).not.toContain("Python, SciPy");
  expect(await offered("R(q) v")).toContain("ROS YAML");
  expect(await offered("Euler angles in degrees")).toContain("three.js");
  await page.goto("/#read?euler=zxz");
  expect(await offered("Euler angles in degrees")).not.toContain("three.js");
});

test("the menu stays inside a small window and closes when the page is touched", async ({
  page,
}) => {
  await page.setViewportSize({ width: 320, height: 640 });
  await page.goto("/");
  for (const of of ["R(q)", "Hamilton q", "minus q"]) {
    await menuOf(page, of).click();
    const box = await page.getByRole("menu").boundingBox();
    expect(box?.x).toBeGreaterThanOrEqual(0);
    expect(box?.y).toBeGreaterThanOrEqual(0);
    expect((box?.x ?? 0) + (box?.width ?? 0)).toBeLessThanOrEqual(320);
    expect((box?.y ?? 0) + (box?.height ?? 0)).toBeLessThanOrEqual(640);
    await page.mouse.click(2, (box?.y ?? 0) > 300 ? 2 : 638);
    await expect(page.getByRole("menu")).toHaveCount(0);
  }
});

test("a test vector holds the text and the link, but not those of another result", async ({
  page,
}) => {
  await page.goto(jplLog);
  await menuOf(page, "JPL q").click();
  await item(page, "Test vector").click();
  await expect.poll(() => clipboard(page)).toContain("testVector");
  const vector = JSON.parse(await clipboard(page));
  expect(vector.source.quaternion).toBe("0.1 -0.2 0.4 0.888819441731559");
  expect(vector.source.as).toBe("jpl");
  expect(vector.link).toMatch(/#read\?v=1&quaternion=0\.1/);
  expect(vector.convention.handedness).toBe("left");
  expect(vector.expected.matrix[0][1]).toBeCloseTo(0.671055553385247, 15);

  await page.getByRole("textbox", { name: "quaternion q" }).fill("oops");
  await page.getByRole("button", { name: "Copy JPL q as Test vector", exact: true }).click();
  await expect.poll(() => clipboard(page)).not.toContain("source");
  expect(JSON.parse(await clipboard(page)).array[0]).toBe(0.1);
});

test("copying works where the browser takes no promise, and a refusal is said", async ({
  page,
}) => {
  await page.addInitScript(() => {
    Object.defineProperty(window, "ClipboardItem", { value: undefined });
    localStorage.setItem("quatlas.copy-format", "matlab");
  });
  await page.goto(jplLog);
  await page.getByRole("button", { name: "Copy JPL q as MATLAB", exact: true }).click();
  await expect.poll(() => clipboard(page)).toContain("q_wxyz = quaternion(0.888819441731559, 0.1");
  await page.evaluate(() => {
    navigator.clipboard.writeText = () => Promise.reject(new Error("refused"));
  });
  await page.getByRole("button", { name: "Copy JPL q as MATLAB", exact: true }).click();
  await expect(page.getByText("JPL q not copied: the browser does not allow it")).toBeVisible();
});

test("a stored format that is none, and a browser that stores nothing, change nothing", async ({
  page,
}) => {
  await page.addInitScript(() => localStorage.setItem("quatlas.copy-format", "__proto__"));
  await page.goto("/");
  await expect(page.getByRole("button", { name: "Copy Hamilton q", exact: true })).toBeVisible();
  await page.addInitScript(() => {
    Object.defineProperty(window, "localStorage", {
      get: () => {
        throw new Error("denied");
      },
    });
  });
  await page.reload();
  await menuOf(page, "Hamilton q").click();
  await item(page, "JavaScript").click();
  await expect(
    page.getByRole("button", { name: "Copy Hamilton q as JavaScript", exact: true }),
  ).toBeVisible();
});

test("what the page copies, the page reads as the same attitude", async ({ page }) => {
  await page.goto(jplLog);
  const field = page.getByRole("textbox", { name: "quaternion q" });
  for (const format of ["C++, Eigen", "JavaScript", "MATLAB", "JSON"]) {
    await menuOf(page, "JPL q").click();
    await item(page, format).click();
    await expect(page.getByText(`JPL q copied as ${format}`, { exact: true })).toBeVisible();
    await field.focus();
    await page.keyboard.press("ControlOrMeta+a");
    await page.keyboard.press("ControlOrMeta+v");
    await expect(page.locator(".result.current")).toBeVisible();
    await expect(field).not.toHaveValue("0.1 -0.2 0.4 0.888819441731559");
    await menuOf(page, "JPL q").click();
    await item(page, "Numbers").click();
    await expect.poll(() => clipboard(page)).toBe("[0.1, -0.2, 0.4, 0.888819441731559]");
  }
});

test("axe finds nothing in an open menu", async ({ page }) => {
  await page.goto("/");
  await menuOf(page, "R(q)").click();
  await expect(page.getByRole("menu")).toBeVisible();
  expect(await violationsIn(page, ".popup")).toEqual([]);
});
