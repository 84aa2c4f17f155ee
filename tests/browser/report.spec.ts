// What the Read view says of an attitude beyond its numbers: product matrices, what each convention
// multiplies, the matrix beside it, vectors of tangents, a sequence that is free; and what copies say.
import { readFileSync } from "node:fs";
import { initSync, presets } from "../../pkg/quatlas.js";
import {
  expect,
  matrix,
  numberOf,
  numbersOf,
  openEverything,
  test,
  textsOf,
} from "./support/page.ts";

const printed: { handedness: string; order: string; left: string; right: string }[] = JSON.parse(
  readFileSync(new URL("../cases/product_matrices.json", import.meta.url), "utf8"),
);

initSync({ module: readFileSync(new URL("../../pkg/quatlas_bg.wasm", import.meta.url)) });

test("the product matrices are those of the four numbers as typed", async ({ page }) => {
  await page.goto("/#read?quaternion=1+2+3+4");
  await expect(matrix(page, "R(q)")).toBeVisible();
  await openEverything(page);
  // Yoosefian 2021, eq. 7.
  expect(await numbersOf(matrix(page, "Hamilton left product matrix"))).toEqual([
    1, -2, -3, -4, 2, 1, -4, 3, 3, 4, 1, -2, 4, -3, 2, 1,
  ]);
  const products = page.locator(".fold .hamilton");
  await expect(products).toContainText("on [w, x, y, z], of q with its norm");
  await page.getByRole("textbox", { name: "quaternion q" }).fill("1 0 0 0");
  await expect(products).toContainText("on [w, x, y, z]");
  await expect(products).not.toContainText("with its norm");
});

test("all eight product matrices of the field guide can be read off the page", async ({ page }) => {
  const quaternion: Record<string, number> = { w: 1, x: 2, y: 3, z: 4 };
  const numbersIn = (names: string) =>
    names.split(/ +/).map((name) => {
      const size = quaternion[name.replace("-", "")] ?? Number.NaN;
      return name.startsWith("-") ? -size : size;
    });
  const expectPrinted = async (name: string, handedness: string, order: string) => {
    const { left, right } = printed.find(
      (one) => one.handedness === handedness && one.order === order,
    ) ?? { left: "", right: "" };
    const shown = (side: string) => numbersOf(matrix(page, `${name} ${side} product matrix`));
    await expect.poll(() => shown("left"), { message: name }).toEqual(numbersIn(left));
    expect(await shown("right"), name).toEqual(numbersIn(right));
  };
  const choose = async (name: string | RegExp) => {
    await page.getByRole("radio", { name }).first().focus();
    await page.keyboard.press("Space");
  };
  await page.goto("/#read?quaternion=w=1+x=2+y=3+z=4");
  await openEverything(page);
  await expectPrinted("Hamilton", "right", "scalar-first");
  await expectPrinted("JPL", "left", "scalar-last");
  await choose(/scalar last/);
  await expectPrinted("Hamilton as Eigen and ROS store it", "right", "scalar-last");
  await choose(/^JPL/);
  await choose(/scalar first/);
  await expectPrinted("Your convention", "left", "scalar-first");
});

test("both columns say what they multiply, and small turns on the world's axes change sides", async ({
  page,
}) => {
  const rules = (name: string) => page.getByRole("list", { name: `What ${name} multiplies` });
  await page.goto("/");
  await page.getByText("What each convention multiplies").click();
  await expect(rules("Hamilton").getByRole("listitem")).toHaveText([
    "By labels qBC∘qAB is qAC.",
    "A camera C on the body B: qWB∘qBC is its quaternion in the world.",
    "A small rotation about the body's axes: q∘δq.",
    "The body's angular velocity: q̇ = ½ q∘ω.",
  ]);
  await expect(rules("JPL").getByRole("listitem")).toHaveText([
    "By labels qBC∘qAB is qAC.",
    "A camera C on the body B: qBC∘qWB is its quaternion in the world.",
    "A small rotation about the body's axes: δq∘q.",
    "The body's angular velocity: q̇ = ½ ω∘q.",
  ]);
  await page.locator(".more > summary").click();
  await page.getByRole("radio", { name: /^global/ }).check();
  await expect(rules("Hamilton")).toContainText("A small rotation about the world's axes: δq∘q.");
  await expect(rules("JPL")).toContainText("A small rotation about the world's axes: q∘δq.");
  await expect(rules("JPL")).toContainText("q̇ = ½ ω∘q");
});

test("conventions with a name are one click away, My Lab with its matrix", async ({ page }) => {
  await page.goto("/#read?quaternion=rotvec+0.4+-0.7+1.1");
  await page.locator(".more > summary").click();
  const named = page.getByRole("list", { name: "Named conventions" });
  const button = (name: RegExp) => named.getByRole("button", { name });
  await expect(button(/^Hamilton$/)).toHaveAttribute("aria-pressed", "true");
  await button(/My Lab/).click();
  await expect(button(/My Lab/)).toHaveAttribute("aria-pressed", "true");
  await expect(page).toHaveURL(/function=active&direction=world-to-body&rows=world-to-body/);
  const card = page.getByRole("region", { name: "“My Lab” of the field guide" });
  // Golden case G32: Hamilton's numbers, and mylab_matrix_R_WtoB.
  expect((await textsOf(card.locator(".strip dd"))).map(numberOf)).toEqual([
    0.776371, 0.184856, -0.323499, 0.508355,
  ]);
  await page.getByText("and the matrix as chosen beside q").click();
  const paired = await numbersOf(matrix(page, "matrix as chosen beside q"));
  expect(paired.slice(0, 3)).toEqual([0.273847, 0.669743, 0.690255]);
  await expect(page.locator(".fold .matrix-caption", { hasText: "passive" })).toHaveText(
    "chosen beside q: passive, world → body",
  );
  await expect(page.locator(".more-panel")).toContainText(
    "For the four numbers as declared it is C(q).",
  );
  await button(/^JPL$/).click();
  await expect(page.getByRole("radio", { name: /^JPL/ })).toBeChecked();
  await expect(page).not.toHaveURL(/rows=/);
  await expect(page.locator(".more-panel")).toContainText("it is R(q).");
  // The engine of the page and the constants of the package are the core's.
  expect(presets().myLab).toEqual({
    ...presets().hamilton,
    function: "active",
    direction: "world-to-body",
  });
});

test("the Gibbs vector and the modified Rodrigues parameters are facts that can be copied", async ({
  page,
  context,
}) => {
  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  await page.goto("/");
  const tangents = page.getByText("Gibbs vector and modified Rodrigues parameters");
  await tangents.click();
  const fact = (name: string) =>
    page.locator(".tangent", { has: page.getByRole("heading", { name, exact: true }) });
  await expect(fact("Gibbs vector")).toContainText("[0, 0, 0.414214]");
  await expect(fact("Modified Rodrigues parameters")).toContainText("[0, 0, 0.198912]");
  const copied = async (name: string) => {
    await page.getByRole("button", { name: `Copy ${name}`, exact: true }).click();
    await expect(page.getByText(`${name} copied`, { exact: true })).toBeVisible();
    return page.evaluate(() => navigator.clipboard.readText());
  };
  expect(await copied("Gibbs vector")).toMatch(/^gibbs \[0, 0, 0\.41421356237309\d+\]$/);
  expect(await copied("modified Rodrigues parameters")).toMatch(
    /^mrp \[0, 0, 0\.19891236737965\d+\]$/,
  );
  await page.goto("/#read?quaternion=180°+about+z");
  await expect(fact("Gibbs vector")).toContainText("infinite: half a turn");
  await expect(fact("Modified Rodrigues parameters")).toContainText("[0, 0, 1]");
});

test("at gimbal lock a sequence that is free is one click away", async ({ page }) => {
  await page.goto("/#read?quaternion=ZYX+30°+90°+10°");
  const fact = page.locator(".fact-euler");
  await expect(fact).toContainText("Gimbal lock");
  // What stands above it stays where it is.
  const top = () => fact.evaluate((node) => node.getBoundingClientRect().top + scrollY);
  const locked = await top();
  await fact.getByRole("button", { name: "Show y-z-x" }).click();
  await expect(fact).not.toContainText("Gimbal lock");
  await expect(fact.getByRole("combobox", { name: "Euler axes" })).toHaveValue("yzx");
  await expect(page).toHaveURL(/euler=YZX/);
  // As far from its lock as can be.
  const angles = (await textsOf(fact.locator(".euler-angles dd"))).map(numberOf);
  expect(angles[1]).toBeCloseTo(0, 10);
  expect(await top()).toBe(locked);
  await page.goto("/#read?quaternion=ZYX+30°+80°+10°");
  await expect(fact.getByRole("button", { name: /^Show/ })).toHaveCount(0);
});

test("a matrix is only said to be printed where the library prints it", async ({ page }) => {
  const ends = page.locator(".columns .column");
  // Eigen makes another matrix of a norm that is not 1, SciPy normalises, JPL prints nothing.
  await page.goto("/#translate?translated=0.02+-0.01+0.38+0.92&from=eigen&to=scipy");
  await expect(ends.nth(0)).toContainText("of q/|q|, R(q)");
  await expect(ends.nth(0)).not.toContainText("as printed");
  await expect(ends.nth(1)).toContainText("as printed, R(q)");
  await page.goto("/#translate?translated=0+0+0.6+0.8&from=eigen&to=scipy");
  await expect(ends.nth(0)).toContainText("as printed, R(q)");
  await expect(ends.nth(1)).toContainText("as printed, R(q)");
});

test("the norm in a copy is the one on the page", async ({ page, context }) => {
  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  await page.goto("/#read?quaternion=0.02+-0.01+0.38+0.92&digits=all");
  // 0.995640497368402583…, rounded once; Math.hypot says …4027.
  const norm = "0.9956404973684025";
  await expect(page.locator(".read-as")).toContainText(`norm ${norm}`);
  await page.getByRole("button", { name: "Formats of Hamilton q", exact: true }).click();
  await page.getByRole("menuitemradio", { name: "Test vector" }).click();
  const copied = () => page.evaluate(() => navigator.clipboard.readText());
  await expect.poll(copied).toContain("testVector");
  const vector = JSON.parse(await copied());
  expect(vector.is).toContain(`its norm is ${norm}, not 1`);
  expect(vector.expected.form).toBe("R(q/|q|)");
});
