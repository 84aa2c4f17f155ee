// The Translate view, by keyboard.
import type { Page } from "@playwright/test";
import {
  expect,
  matrix,
  numbersOf,
  openEverything,
  quaternionField,
  sidewaysScroll,
  tabTo,
  test,
  typeOver,
  violationsOf,
} from "./support/page.ts";

const picker = (page: Page, side: "From" | "To") =>
  page.getByRole("combobox", { name: side, exact: true });
const strip = (page: Page, at: number) => page.locator(".translation-end").nth(at).locator("dd");
const headline = (page: Page) => page.locator("#translation-name");

test("opens on a filter's log, translated, with every output filled", async ({ page }) => {
  await page.goto("/#translate");
  await expect(headline(page)).toHaveText("Reordered, not conjugated");
  await expect(strip(page, 0)).toHaveText(["0.100000", "−0.200000", "0.400000", "0.888819"]);
  await expect(strip(page, 1)).toHaveText(["0.888819", "0.100000", "−0.200000", "0.400000"]);
  await expect(page.locator(".why")).toContainText(
    "OpenVINS takes world coordinates to body coordinates by C(q), Ceres rotation.h takes body coordinates to world coordinates by R(q).",
  );
  // By hand: w² + x² − y² − z² = 0.6, 2(xy − wz) = −0.04 − 0.8·0.888819.
  const there = await numbersOf(matrix(page, "matrix of Ceres rotation.h"));
  expect(there.slice(0, 2)).toEqual([0.6, -0.751056]);
  const here = await numbersOf(matrix(page, "matrix of OpenVINS"));
  expect(here).toEqual([0, 3, 6, 1, 4, 7, 2, 5, 8].map((at) => there[at]));
  await expect(page.getByText("double q[4] = {0.888819441731559, 0.1, -0.2, 0.4};")).toBeVisible();
  await expect(page.locator(".product-line")).toContainText("QuaternionProduct(b, a, ab)");
  await expect(page.getByRole("status")).toHaveText(
    "Result for Ceres rotation.h: w 0.888819, x 0.100000, y −0.200000, z 0.400000. Reordered, not conjugated.",
  );
});

test("libraries are found by typing, and chosen by keyboard", async ({ page }) => {
  await page.goto("/#translate");
  const to = picker(page, "To");
  await tabTo(page, to);
  await page.keyboard.type("rotation.from");
  await expect(to).toHaveAttribute("aria-expanded", "true");
  await page.keyboard.press("Escape");
  await expect(to).toHaveValue("Ceres rotation.h");
  await expect(to).toHaveAttribute("aria-expanded", "false");

  await typeOver(page, "scipy");
  const options = page.getByRole("listbox").getByRole("option");
  await expect(options.first()).toContainText("SciPy Rotation");
  await expect(options.first()).toContainText("1.17.1, run");
  await page.keyboard.press("ArrowDown");
  await expect(options.nth(1)).toHaveAttribute("aria-selected", "true");
  await page.keyboard.press("Home");
  await expect(options.first()).toHaveAttribute("aria-selected", "true");
  await page.keyboard.press("Enter");
  await expect(to).toHaveValue("SciPy Rotation");
  await expect(headline(page)).toHaveText("Neither reordered nor conjugated");
  await expect(page).toHaveURL(/translate\?v=1&to=scipy$/);

  // Without typing the list stands at what is chosen.
  await page.keyboard.press("ArrowDown");
  await expect(page.locator('[aria-selected="true"]')).toContainText("SciPy Rotation");
  await page.keyboard.press("End");
  await page.keyboard.press("Home");
  await expect(page.locator('[aria-selected="true"]')).toContainText("Hamilton");
  await page.keyboard.press("Enter");
  await expect(page).toHaveURL(/to=:hamilton$/);

  await typeOver(page, "nobody knows this one");
  await expect(page.getByText("No library here is called")).toBeVisible();
  await page.keyboard.press("Enter");
  await page.keyboard.press("Tab");
  await expect(to).toHaveValue("Hamilton");
});

test("a library is found by its other words, its language and its group", async ({ page }) => {
  await page.goto("/#translate");
  const options = page.getByRole("listbox").getByRole("option");
  for (const [typed, name] of [
    ["Eigen3", "Eigen Quaternion"],
    ["geometry2", "ROS tf2"],
    ["rust nalgebra", "nalgebra UnitQuaternion"],
    ["jpl", "JPL"],
    ["kuka euler angles", "device, A B C in degrees"],
  ] as const) {
    await picker(page, "From").fill(typed);
    await expect(options.first()).toContainText(name);
  }
});

test("what the quaternion takes can be said, and decides about the conjugate", async ({ page }) => {
  await page.goto("/#translate?to=eigen");
  const to = page.getByRole("group", { name: "To", exact: true });
  await expect(to.getByRole("radio", { name: "body → world custom" })).toBeChecked();
  await to.getByRole("radio", { name: "body → world custom" }).focus();
  await page.keyboard.press("ArrowRight");
  await expect(headline(page)).toHaveText("Conjugated, not reordered");
  await expect(strip(page, 1)).toHaveText(["−0.100000", "0.200000", "−0.400000", "0.888819"]);
  await expect(page.locator(".why")).toContainText("they need conjugate numbers");
  await expect(page).toHaveURL(/to=eigen~world-to-body/);
  // The numbers of Eigen's array, and those of its constructor.
  await expect(page.locator(".column").nth(1)).toContainText("as its constructor takes them");
  await to.getByRole("radio", { name: "w x y z its constructor" }).check();
  await expect(headline(page)).toHaveText("Reordered and conjugated");
  await expect(page).toHaveURL(/to=eigen~scalar-first~world-to-body/);
  await expect(page.locator(".mistake-words")).toHaveText([
    "copied as they are",
    "reordered, but not conjugated",
    "conjugated, but not reordered",
  ]);
});

test("a convention of one's own starts from what stands there", async ({ page }) => {
  await page.goto("/#translate");
  await tabTo(page, picker(page, "From"));
  await page.keyboard.type("custom");
  await page.keyboard.press("Enter");
  await expect(headline(page)).toHaveText("Reordered, not conjugated");
  const from = page.getByRole("group", { name: "From", exact: true });
  const direction = from.getByRole("radiogroup", { name: "Direction" });
  await expect(direction.getByRole("radio", { name: "world to body" })).toBeChecked();
  await direction.getByRole("radio", { name: "body to world" }).check();
  await expect(headline(page)).toHaveText("Reordered and conjugated");
  await expect(page).toHaveURL(/from=:scalar-last,left,passive,body-to-world,local/);
});

test("swapping the sides mirrors the result", async ({ page }) => {
  await page.goto(
    "/#translate?translated=0.3+0.1+-0.7+0.2&from=eigen~world-to-body&to=matlab-aerospace&world=NED+to+ENU&body=x+-y+-z&digits=all",
  );
  const columns = async () => [
    await strip(page, 0).allTextContents(),
    await strip(page, 1).allTextContents(),
  ];
  await expect(strip(page, 1).first()).toBeVisible();
  const before = await columns();
  await tabTo(page, page.getByRole("button", { name: "Swap sides" }));
  await page.keyboard.press("Enter");
  await expect(picker(page, "From")).toHaveValue("MATLAB Aerospace Toolbox");
  await expect(picker(page, "To")).toHaveValue("Eigen Quaternion");
  await expect(page.getByRole("textbox", { name: "axes of the world" })).toHaveValue("ENU to NED");
  await expect(page.getByRole("textbox", { name: "axes of the body" })).toHaveValue("x -y -z");
  const after = await columns();
  expect(after[0]).toEqual(before[1]);
  // New axes round: the numbers come back to the last digits, and are as long as they were.
  const back = after[1]?.map((text) => Number(text.replace("−", "-"))) ?? [];
  const sign = Math.sign(back[0] ?? 1);
  [0.3, 0.1, -0.7, 0.2].forEach((number, at) => {
    expect((back[at] ?? 0) * sign).toBeCloseTo(number, 14);
  });
});

test("swapping without new axes is exact, and twice is nothing", async ({ page }) => {
  await page.goto("/#translate?digits=all");
  const before = await page.locator(".translation-numbers").textContent();
  const swap = page.getByRole("button", { name: "Swap sides" });
  await swap.click();
  await expect(quaternionField(page)).toHaveValue("0.888819441731559 0.1 -0.2 0.4");
  await swap.click();
  await expect(page.locator(".translation-numbers")).toHaveText(before ?? "");
  await expect(page).toHaveURL(/#translate\?v=1&digits=all$/);
});

test("a pasted call proposes its library", async ({ page }) => {
  await page.goto("/#translate");
  await quaternionField(page).fill("Eigen::Quaterniond(0.8, 0.2, -0.4, 0.4)");
  const propose = page.getByRole("button", { name: "translate from Eigen Quaternion" });
  await tabTo(page, propose);
  await page.keyboard.press("Enter");
  await expect(picker(page, "From")).toHaveValue("Eigen Quaternion");
  await expect(propose).toBeHidden();
  // Ceres takes the order in which Eigen's constructor was called.
  await expect(strip(page, 1)).toHaveText(["0.800000", "0.200000", "−0.400000", "0.400000"]);
});

test("axes are a step of their own: a heading of PX4 in ROS", async ({ page }) => {
  await page.goto(
    "/#translate?translated=0.7071067811865476+0+0+0.7071067811865476&from=px4-vehicle-attitude&to=ros-geometry-msgs",
  );
  await tabTo(page, page.locator("summary", { hasText: "Axes" }));
  await page.keyboard.press("Enter");
  await tabTo(page, page.getByRole("textbox", { name: "axes of the world" }));
  await page.keyboard.type("ned to enu");
  await tabTo(page, page.getByRole("combobox", { name: "Named axes of the body" }));
  await page.keyboard.type("FRD");
  // A body that heads east, on axes whose x is east: no turn.
  await expect(strip(page, 1)).toHaveText(["0", "0", "0", "1"]);
  expect(await numbersOf(matrix(page, "new axes of the world"))).toEqual([
    0, 1, 0, 1, 0, 0, 0, 0, -1,
  ]);
  await expect(page.locator(".matrix-caption").last()).toContainText("determinant +1");
  await expect(page.locator(".mistakes")).toContainText("axes not changed90° off");
  await expect(page).toHaveURL(/world=ned\+to\+enu&body=FRD\+to\+FLU/);
  // What is not established of a message is said.
  const assumed = page.locator(".column").nth(1).locator(".assumed");
  await expect(assumed).toContainText("Assumed: what it does to a vector is not established");
});

test("axes of the other hand on one side only are refused, and mended by one button", async ({
  page,
}) => {
  await page.goto("/#translate");
  await page.locator("summary", { hasText: "Axes" }).click();
  await page.getByRole("textbox", { name: "axes of the world" }).fill("ROS to Unity");
  await expect(page.locator(".problem")).toContainText(
    "only one side changes handedness: a reflection, which has no quaternion.",
  );
  await expect(page.locator(".problem")).toContainText(
    "Try: the same change of axes on both sides",
  );
  await expect(page.getByText("Showing the last valid result.", { exact: true })).toBeVisible();
  await expect(strip(page, 1)).toHaveText(["0.888819", "0.100000", "−0.200000", "0.400000"]);
  await tabTo(page, page.getByRole("button", { name: "Same for the body" }));
  await page.keyboard.press("Enter");
  await expect(page.locator(".hand-words")).toContainText("Both change the handedness of the axes");
  // Unity's axes are −y, z, x of ROS, and an axis of rotation is mirrored once more.
  await expect(strip(page, 1)).toHaveText(["0.888819", "−0.200000", "−0.400000", "−0.100000"]);
  await page.getByRole("textbox", { name: "axes of the body" }).fill("x x y");
  await expect(page.locator(".problem")).toContainText(
    "one axis appears twice, so another one is missing.",
  );
  await page.getByRole("button", { name: "Leave all axes as they are" }).click();
  await expect(page.locator(".problem")).toHaveCount(0);
});

test("the angle of a forgotten step, and numbers that do not show it", async ({ page }) => {
  await page.goto("/#translate?translated=1+0+0+0&from=:hamilton&to=scipy");
  // [1, 0, 0, 0] read as x y z w is half a turn; an identity has no conjugate to forget.
  await expect(page.locator(".mistakes li")).toHaveText([
    /^not reordered180° off$/,
    /^conjugated needlesslyno difference with these numbers; others show the mistake$/,
  ]);
  await quaternionField(page).fill("0.5 0.5 0.5 0.5");
  await expect(page.locator(".mistakes li").first()).toContainText("no difference");
});

test("an error keeps the last result, with the place marked", async ({ page }) => {
  await page.goto("/#translate");
  await tabTo(page, quaternionField(page));
  await typeOver(page, "0 0 0.6 0.8");
  await expect(strip(page, 1)).toHaveText(["0.800000", "0", "0", "0.600000"]);
  await page.keyboard.type(" oops");
  await expect(page.locator("mark")).toHaveText("oops");
  await expect(page.getByText("Showing the last valid result.", { exact: true })).toBeVisible();
  await expect(strip(page, 1)).toHaveText(["0.800000", "0", "0", "0.600000"]);
  await expect(page.getByRole("status")).toHaveText(/^Problem in q: oops/);
});

test("a problem in a line of code is marked where it was typed", async ({ page }) => {
  await page.goto("/#translate?from=eigen");
  await quaternionField(page).fill("Eigen::Quaterniond q(1e999, 0, 0, 0);");
  await expect(page.locator("mark")).toHaveText("1e999");
  // The emoji takes two units of a text field, and four bytes.
  await page.goto("/#translate?from=drake");
  await quaternionField(page).fill("🙂 = Quaternion(0, 0, 1e999, 0)");
  await expect(page.locator("mark")).toHaveText("1e999");
  await quaternionField(page).fill("q = Quaternion(0, 0, 0, 0)");
  await expect(page.locator("mark")).toHaveText("q = Quaternion(0, 0, 0, 0)");
});

test("reloading the address gives the same page", async ({ page }) => {
  await page.goto("/#translate");
  await quaternionField(page).fill("0.5, 0.5, -0.5, 0.5");
  await picker(page, "From").fill("directx");
  await page.keyboard.press("Enter");
  await picker(page, "To").fill("unity q");
  await page.keyboard.press("Enter");
  await page.locator("summary", { hasText: "Axes" }).click();
  await page.getByRole("textbox", { name: "axes of the body" }).fill("x -y -z");
  await expect(page).toHaveURL(/from=directxmath.*/);
  await expect(page).toHaveURL(/body=x\+-y\+-z/);
  const before = await page.locator("main").innerText();
  await page.reload();
  await expect(headline(page)).toBeVisible();
  expect(await page.locator("main").innerText()).toEqual(before);
});

for (const hostile of [
  "translate?from=__proto__&to=constructor",
  "translate?from=eigen~middle~up~~&to=:1,2,3,4,5,6",
  "translate?from=%E0%A4%A&to=%00&world=%F0%9F%99%82&body=<b>x</b>",
  `translate?translated=${"(".repeat(5000)}`,
]) {
  test(`a hostile address opens: ${hostile.slice(0, 50)}`, async ({ page }) => {
    await page.goto(`/#${hostile}`);
    await expect(headline(page)).toBeVisible();
    await expect(page.locator(".failure")).toHaveCount(0);
  });
}

for (const colorScheme of ["light", "dark"] as const) {
  test(`no accessibility violation with everything open: ${colorScheme}`, async ({ page }) => {
    await page.emulateMedia({ colorScheme });
    await page.goto("/#translate?from=:jpl&to=unity&world=ROS+to+Unity&body=ROS+to+Unity");
    await page.getByRole("combobox", { name: "To", exact: true }).press("ArrowDown");
    expect(await violationsOf(page)).toEqual([]);
  });

  test(`no accessibility violation beside a problem: ${colorScheme}`, async ({ page }) => {
    await page.emulateMedia({ colorScheme });
    await page.goto("/#translate?world=ROS+to+Unity");
    await expect(page.locator(".problem")).toBeVisible();
    expect(await violationsOf(page)).toEqual([]);
  });
}

for (const width of [320, 768, 1280]) {
  test(`no sideways scroll at ${width} px with everything open`, async ({ page }) => {
    await page.setViewportSize({ width, height: 740 });
    for (const address of [
      "/#translate?from=:jpl&world=ROS+to+Unity&body=ROS+to+Unity&digits=all&translated=1+2+3+4.123456789",
      "/#translate?from=matlab-quaternion-frame&to=cesium&digits=all&translated=1e-7+2+3+-4e6",
    ]) {
      await page.goto(address);
      await expect(headline(page)).toBeVisible();
      await openEverything(page);
      await page.getByRole("combobox", { name: "To", exact: true }).press("ArrowDown");
      expect(await sidewaysScroll(page)).toBeLessThanOrEqual(0);
    }
  });
}

test("every library can be an end, in both directions", async ({ page }) => {
  await page.goto("/#libraries");
  await expect(page.locator(".library-row").first()).toBeVisible();
  const links = await page.locator(".library-row a").all();
  const ids = await Promise.all(links.map((link) => link.getAttribute("href")));
  expect(ids.length).toBeGreaterThan(90);
  for (const href of ids.filter((_, at) => at % 9 === 0)) {
    const id = href?.match(/library=([a-z0-9-]+)/)?.[1];
    await page.goto(`/#translate?from=${id}&to=:jpl`);
    await expect(page.locator(".result.current")).toBeVisible();
    await page.goto(`/#translate?from=:jpl&to=${id}`);
    await expect(page.locator(".result.current")).toBeVisible();
    expect(await page.locator("main").innerText()).not.toMatch(/NaN|undefined|null|\{[wxyz]\}/);
  }
});
