// Every number of the result is a field: what is typed there becomes the text, by keyboard.
import type { Locator, Page } from "@playwright/test";
import { axisValues } from "../../www/model/conventions.ts";
import {
  expect,
  matrix,
  numberOf,
  numbersOf,
  quaternionField,
  sidewaysScroll,
  tab,
  tabTo,
  test,
  textsOf,
  typeOver,
  violationsOf,
} from "./support/page.ts";

const field = (page: Page, name: string) => page.getByRole("textbox", { name, exact: true });

/** Types over a number, and stays on it. */
async function edit(page: Page, name: string, text: string) {
  await field(page, name).focus();
  await page.keyboard.insertText(text);
  await page.keyboard.press("Enter");
}

const components = async (page: Page, preset: "hamilton" | "jpl" | "declared") =>
  (await textsOf(page.locator(`.${preset} .strip dd`))).map(numberOf);

/** Rz(30°) Ry(20°) Rx(10°), and its quaternion w x y z: from 40 digits, not from quatlas. */
const turned = [
  ["0.8137976813493737", "-0.4409696105298824", "0.3785223063697925"],
  ["0.4698463103929542", "0.8825641192593856", "0.01802831123629729"],
  ["-0.3420201433256687", "0.16317591116653482", "0.9254165783983234"],
];
const turnedQuaternion = [0.951549, 0.038135, 0.189308, 0.239298];
const turnedAngles = { yaw: 30, pitch: 20, roll: 10 };
const transposed = turned.map((_, row) => turned.map((cells) => cells[row] ?? ""));

async function expectTurned(page: Page) {
  await expect.poll(() => rounded(page)).toEqual(turnedQuaternion);
  for (const [name, angle] of Object.entries(turnedAngles)) {
    const value = await field(page, `${name} in degrees`).inputValue();
    expect(numberOf(value)).toBeCloseTo(angle, 6);
  }
}

async function openNoTurn(page: Page) {
  await page.goto("/#read?quaternion=1+0+0+0");
  await expect(quaternionField(page)).toHaveValue("1 0 0 0");
}

/** The Hamilton components, of which one may have the focus and all its digits. */
async function rounded(page: Page) {
  return (await components(page, "hamilton")).map((number) => Number(number.toFixed(6)));
}

test("a component is edited by keyboard, and the text says all four", async ({ page }) => {
  await page.goto("/");
  const w = field(page, "Hamilton q, w");
  await tabTo(page, w);
  await expect(w).toHaveValue("0.923880");
  await page.keyboard.press("Enter");
  await expect(w).toHaveValue("0.9238795325112867");
  await page.keyboard.type("1/√2");
  await expect(quaternionField(page)).toHaveValue("qw=(1/√2), qx=0, qy=0, qz=0.3826834323650898");
  await expect(field(page, "JPL q, w")).toHaveValue("0.707107");
  // What was typed stays until the quaternion is left.
  await page.keyboard.press("Enter");
  await page.keyboard.press("ArrowRight");
  await expect(w).toHaveValue("1/√2");
  await page.keyboard.press("Tab");
  await expect(w).toHaveValue("0.707107");
  await expect(page.locator(".notes")).toContainText("The norm is");
});

test("a component is that of its column in all 32 conventions", async ({ page }) => {
  test.setTimeout(120_000);
  const choices = Object.entries(axisValues).reduce<string[]>(
    (begun, [axis, values]) =>
      begun.flatMap((text) => values.map((value) => `${text}&${axis}=${value}`)),
    [""],
  );
  expect(choices).toHaveLength(32);
  await page.goto("/");
  for (const choice of choices) {
    for (const [column, name, at] of [
      ["hamilton", "Hamilton q, y", 2],
      ["jpl", "JPL q, x", 0],
      ["declared", "q as declared, z", choice.includes("order=scalar-first") ? 3 : 2],
    ] as const) {
      // The column makes each address another one.
      await page.goto(`/#read?digits=all&quaternion=0.5+0.1+-0.3+0.8${choice}&vector=${at}+0+0`);
      await expect(quaternionField(page)).toHaveValue("0.5 0.1 -0.3 0.8");
      if ((await page.locator(`.card.${column}`).count()) === 0) continue;
      const before = await components(page, column);
      await field(page, name).fill("0.25");
      await expect(quaternionField(page), choice).toHaveValue(/^q[wxyz]=/);
      // What was typed is shown until the group is left: then it is what was read.
      await quaternionField(page).focus();
      // The column follows in a frame of its own.
      const told = { message: `${name}${choice}`, intervals: [20] };
      await expect.poll(() => components(page, column), told).toEqual(before.with(at, 0.25));
    }
  }
});

const matrices = [
  ["R(q)", turned],
  ["inverse of R(q)", transposed],
  ["C(q)", transposed],
  ["inverse of C(q)", turned],
] as const;
for (const [name, rows] of matrices) {
  test(`nine numbers typed into ${name} are that matrix`, async ({ page }) => {
    // Numbers that are read as the other matrix until they are typed into this one.
    const other = name.includes("R") === name.includes("inverse") ? "" : "&rows=world-to-body";
    await page.goto(`/#read?quaternion=1+0+0+0${other}`);
    await tabTo(page, field(page, `${name}, row 1, column 1`));
    for (const row of rows) {
      for (const number of row) {
        // The matrix is half typed and no rotation yet; what was typed stays.
        await page.keyboard.insertText(number);
        await page.keyboard.press("Enter");
        await page.keyboard.press("ArrowRight");
      }
      await page.keyboard.press("ArrowDown");
      await page.keyboard.press("Home");
    }
    const text = `[${rows.map((row) => row.join(", ")).join("; ")}]`;
    await expect(quaternionField(page)).toHaveValue(text);
    await page.keyboard.press("Tab");
    await expectTurned(page);
    await expect(page).toHaveURL(new RegExp(rows[2]?.[2] ?? ""));
    await page.reload();
    await expectTurned(page);
  });
}

test("the matrix of a declared convention is edited as what it is", async ({ page }) => {
  // Right, active, body to world: q∘v∘q⁻¹ takes world coordinates to those of the body.
  await page.goto("/#read?function=active&quaternion=1+0+0+0");
  for (const [row, cells] of transposed.entries()) {
    for (const [column, number] of cells.entries()) {
      const name = `matrix of q as declared, row ${row + 1}, column ${column + 1}`;
      await field(page, name).focus();
      await page.keyboard.insertText(number);
    }
  }
  await page.keyboard.press("Tab");
  await expectTurned(page);
});

test("Euler angles are edited", async ({ page }) => {
  await openNoTurn(page);
  await edit(page, "yaw in degrees", "30");
  await edit(page, "pitch in degrees", "10+10");
  await edit(page, "roll in degrees", "pi/18");
  await page.keyboard.press("Tab");
  await expect(quaternionField(page)).toHaveValue(
    /^ZYX \(.*\*pi\/180\) rad, \(.*\*pi\/180\) rad, \(pi\/18\) rad$/,
  );
  await expectTurned(page);
});

test("axis and angle are edited", async ({ page }) => {
  // 120° about (1, 1, 1): x to y, y to z, z to x.
  await openNoTurn(page);
  await edit(page, "angle in degrees", "120");
  await edit(page, "axis, x", "1");
  await edit(page, "axis, y", "1");
  await expect.poll(() => numbersOf(matrix(page, "R(q)"))).toEqual([0, 0, 1, 1, 0, 0, 0, 1, 0]);
  await expect(quaternionField(page)).toHaveValue("120° about [1, 1, 1]");
  // It has length 1 once it is left.
  await expect(field(page, "axis, y")).toHaveValue("1");
  await page.keyboard.press("Tab");
  await expect(field(page, "axis, y")).toHaveValue("0.577350");
});

test("the rotation vector is edited", async ({ page }) => {
  await openNoTurn(page);
  await edit(page, "rotation vector, x", "-pi/2");
  await expect(quaternionField(page)).toHaveValue("rotvec [(-pi/2), 0, 0] rad");
  await expect.poll(() => numbersOf(matrix(page, "R(q)"))).toEqual([1, 0, 0, 0, 0, 1, 0, -1, 0]);
  await expect(field(page, "angle in degrees")).toHaveValue(/^90(\.0+)?$/);
  await expect(field(page, "axis, x")).toHaveValue("−1");
});

test("the field that is edited is never rewritten, and the others follow each key", async ({
  page,
}) => {
  await page.goto("/#read?quaternion=0.6+0+0+0.8");
  const yaw = field(page, "yaw in degrees");
  await yaw.focus();
  await page.keyboard.press("F2");
  const selected = () =>
    yaw.evaluate((node: HTMLInputElement) => [node.selectionStart, node.selectionEnd]);
  const exact = await yaw.inputValue();
  expect(Number(exact)).toBeCloseTo(106.26020470831196, 12);
  expect(await selected()).toEqual([0, exact.length]);
  let typed = "";
  for (const key of "370.50") {
    await page.keyboard.press(key);
    typed += key;
    await expect(yaw).toHaveValue(typed);
    const half = (Number(typed) * Math.PI) / 360;
    await expect
      .poll(async () => numberOf(await field(page, "Hamilton q, z").inputValue()))
      .toBeCloseTo(Math.sin(half), 6);
  }
  // 370.5° is 10.5°, once the angles are left.
  await page.keyboard.press("Tab");
  await expect(yaw).toHaveValue("10.500000");
});

test("a click selects the whole number", async ({ page }) => {
  await page.goto("/");
  const w = field(page, "JPL q, w");
  await w.click();
  await page.keyboard.type("2");
  await expect(w).toHaveValue("2");
  await expect(quaternionField(page)).toHaveValue("qw=2, qx=0, qy=0, qz=0.3826834323650898");
});

test("a matrix half typed stays as it is, with its problem, beside the last result", async ({
  page,
}) => {
  await openNoTurn(page);
  const cell = field(page, "R(q), row 2, column 2");
  await cell.focus();
  await page.keyboard.type("1/");
  await expect(cell).toHaveAttribute("aria-invalid", "true");
  await expect(cell).toHaveAccessibleDescription(
    /^q: unexpected “\)”\. Showing the last valid result\. Expected: a number or a name\./,
  );
  await expect(field(page, "R(q), row 1, column 1")).toHaveAttribute("aria-invalid", "false");
  await expect(quaternionField(page)).toHaveValue("[1, 0, 0; 0, (1/), 0; 0, 0, 1]");
  await expect(page.locator(".result")).toHaveClass(/old/);
  // Left with its problem, it keeps what was typed; all else is the last good result.
  await page.keyboard.press("Tab");
  await field(page, "yaw in degrees").focus();
  await expect(cell).toHaveValue("1/");
  expect(await components(page, "hamilton")).toEqual([1, 0, 0, 0]);
  // It is recovered from in the text as well.
  await quaternionField(page).fill("[1, 0, 0; 0, (1/1), 0; 0, 0, 1]");
  await expect(cell).toHaveAttribute("aria-invalid", "false");
  await expect(cell).toHaveValue("1");
});

test("what is wrong with all nine numbers is said of all", async ({ page }) => {
  await openNoTurn(page);
  await edit(page, "R(q), row 3, column 3", "-1");
  const invalid = page.locator(".number[aria-invalid=true]");
  await expect(invalid).toHaveCount(9);
  await expect(invalid.first()).toHaveAccessibleDescription(
    /this matrix is a reflection, not a rotation/,
  );
  expect(await violationsOf(page)).toEqual([]);
});

test("Escape restores the number before the edit, Enter takes it", async ({ page }) => {
  await openNoTurn(page);
  await edit(page, "Hamilton q, x", "1");
  await page.keyboard.press("ArrowRight");
  await page.keyboard.type("oops");
  await expect(page.locator(".problem")).toBeVisible();
  await page.keyboard.press("Escape");
  await expect(field(page, "Hamilton q, y")).toHaveValue("0");
  await expect(field(page, "Hamilton q, y")).toBeFocused();
  await expect(quaternionField(page)).toHaveValue("qw=1, qx=1, qy=0, qz=0");

  const cell = field(page, "R(q), row 1, column 2");
  await cell.focus();
  await page.keyboard.type("0.1");
  await page.keyboard.press("Enter");
  await expect(cell).toBeFocused();
  await expect(cell).toHaveValue(/^\s*0\.100000$/);
  // The nearest rotation has another number there, once the matrix is left.
  await page.keyboard.press("Tab");
  await expect(cell).not.toHaveValue(/0\.100000/);
  await expect(page.locator(".notes")).toContainText("nearest rotation");
});

test("the arrow keys step a number", async ({ page }) => {
  await page.goto("/#read?quaternion=ZYX+30%C2%B0+20%C2%B0+10%C2%B0");
  const pitch = field(page, "pitch in degrees");
  await pitch.focus();
  await page.keyboard.type("20");
  for (const [keys, value] of [
    ["ArrowUp", "21"],
    ["Shift+ArrowDown", "11"],
    ["Alt+ArrowUp", "11.1"],
  ] as const) {
    await page.keyboard.press(keys);
    await expect(pitch).toHaveValue(value);
  }
  await expect(quaternionField(page)).toHaveValue(/^ZYX .*°, 11\.1°, .*°$/);
  const x = field(page, "rotation vector, x");
  await x.focus();
  await page.keyboard.type("1/4");
  await page.keyboard.press("ArrowDown");
  await expect(x).toHaveValue("0.24");
});

test("the axis of no turn can still be given an angle", async ({ page }) => {
  await openNoTurn(page);
  await expect(page.getByText("This is the identity: no rotation.")).toBeVisible();
  const angle = field(page, "angle in degrees");
  await angle.focus();
  await page.keyboard.press("Enter");
  await page.keyboard.press("ArrowUp");
  await expect(quaternionField(page)).toHaveValue("1° about [0, 0, 1]");
});

const tops = (elements: Locator) =>
  elements.evaluateAll((found) => found.map((node) => node.getBoundingClientRect().top));

for (const width of [1280, 390]) {
  test(`nothing moves while numbers are edited, ${width} px`, async ({ page }) => {
    await page.setViewportSize({ width, height: 900 });
    await page.goto("/");
    const all = page.locator(".column.hamilton :is(.number, .row, .copy)");
    const cell = field(page, "R(q), row 2, column 2");
    await cell.scrollIntoViewIfNeeded();
    const before = await tops(all);
    const boxes = () =>
      all.evaluateAll((found) =>
        found.map((node) =>
          // A width in letters is rounded to a sixty-fourth of a pixel.
          node === document.activeElement ? 0 : node.getBoundingClientRect().left.toFixed(1),
        ),
      );
    await cell.focus();
    await page.keyboard.press("Enter");
    const places = await boxes();
    for (const key of ["0", ".", "7", "Backspace", "x", "Backspace", "5", "ArrowUp"]) {
      await page.keyboard.press(key);
      // The page is scrolled by whole pixels.
      const moved = (await tops(all)).map((top, at) => Math.abs(top - (before[at] ?? 0)));
      expect(Math.max(...moved), key).toBeLessThan(1);
      expect(await boxes(), key).toEqual(places);
    }
    expect(await sidewaysScroll(page)).toBeLessThanOrEqual(0);
    // The text field shows all of its text again once it is edited itself.
    const hero = quaternionField(page);
    await hero.focus();
    expect(await hero.evaluate((node) => node.scrollHeight - node.clientHeight)).toBeLessThan(2);
  });
}

test("undo and redo by key, in and across fields", async ({ page }) => {
  await page.goto("/");
  const hero = quaternionField(page);
  const opened = "cos(pi/8) + sin(pi/8) k";
  await tabTo(page, hero);
  await typeOver(page, "0.5 0.5 0.5 0.5");
  await edit(page, "pitch in degrees", "20");
  await page.getByRole("radio", { name: /^JPL/ }).check();
  await page.getByRole("link", { name: "ROS message" }).click();
  await expect(hero).toHaveValue(/^x: 0\.0/);

  const said = page.locator("[data-said=done]");
  await page.keyboard.press("ControlOrMeta+z");
  await expect(page.getByRole("radio", { name: /^JPL/ })).toBeChecked();
  await expect(said).toHaveText("Undone: convention, quaternion, vector");
  await page.keyboard.press("ControlOrMeta+z");
  await expect(page.getByRole("radio", { name: /^Hamilton/ })).toBeChecked();
  await expect(hero).toHaveValue(/^ZYX .*°, 20°, /);
  await expect(said).toHaveText("Undone: convention");
  await page.keyboard.press("ControlOrMeta+z");
  await expect(hero).toHaveValue("0.5 0.5 0.5 0.5");
  await page.keyboard.press("ControlOrMeta+z");
  await expect(hero).toHaveValue(opened);
  await page.keyboard.press("ControlOrMeta+z");
  await expect(hero).toHaveValue(opened);
  for (let presses = 0; presses < 4; presses += 1)
    await page.keyboard.press("ControlOrMeta+Shift+z");
  await expect(hero).toHaveValue(/^x: 0\.0/);
  await expect(said).toHaveText("Redone: convention, quaternion, vector");
  await expect(page).toHaveURL(/quaternion=x/);
  await page.keyboard.press("ControlOrMeta+z");
  await page.keyboard.press("ControlOrMeta+y");
  await expect(hero).toHaveValue(/^x: 0\.0/);
});

test("undo in a text leaves the caret where the change was", async ({ page }) => {
  await openNoTurn(page);
  const hero = quaternionField(page);
  await hero.focus();
  await page.keyboard.press("Home");
  for (let presses = 0; presses < 3; presses += 1) await page.keyboard.press("ArrowRight");
  await page.keyboard.type(".5");
  await page.keyboard.press("ControlOrMeta+z");
  await expect(hero).toHaveValue("1 0 0 0");
  expect(await hero.evaluate((node: HTMLTextAreaElement) => node.selectionStart)).toBe(3);
  await page.keyboard.press("ControlOrMeta+y");
  await expect(hero).toHaveValue("1 0.5 0 0");
  expect(await hero.evaluate((node: HTMLTextAreaElement) => node.selectionStart)).toBe(5);
});

test("undo within a matrix gives back what was typed there", async ({ page }) => {
  await openNoTurn(page);
  await edit(page, "R(q), row 1, column 1", "0.9");
  await page.keyboard.press("ArrowRight");
  await page.keyboard.type("0.1");
  await page.keyboard.press("ControlOrMeta+z");
  await expect(field(page, "R(q), row 1, column 2")).toHaveValue("0");
  await expect(field(page, "R(q), row 1, column 1")).toHaveValue("0.900000");
  await page.keyboard.press("ControlOrMeta+z");
  await expect(field(page, "R(q), row 1, column 1")).toHaveValue("1");
  await expect(quaternionField(page)).toHaveValue("1 0 0 0");
});

test("the buttons of undo and redo tell what they can", async ({ page }) => {
  await page.goto("/");
  const undo = page.getByRole("button", { name: "Undo" });
  const redo = page.getByRole("button", { name: "Redo" });
  await expect(undo).toHaveAttribute("aria-disabled", "true");
  await quaternionField(page).fill("1 0 0 0");
  await expect(undo).toHaveAttribute("aria-disabled", "false");
  await tabTo(page, undo);
  await page.keyboard.press("Enter");
  await expect(quaternionField(page)).toHaveValue("cos(pi/8) + sin(pi/8) k");
  await expect(undo).toHaveAttribute("aria-disabled", "true");
  await expect(undo).toBeFocused();
  await page.keyboard.press("Enter");
  await page.keyboard.press("Tab");
  await expect(redo).toBeFocused();
  await page.keyboard.press("Space");
  await expect(quaternionField(page)).toHaveValue("1 0 0 0");
  // What is not of this view stays.
  await tab(page, "Libraries").click();
  await expect(page.getByRole("button", { name: "Undo" })).toHaveAttribute("aria-disabled", "true");
});

test("what is wrong in a number stands under it, and Alt+Enter mends it there", async ({
  page,
}) => {
  await page.goto("/");
  const cell = field(page, "R(q), row 1, column 1");
  await cell.focus();
  await page.keyboard.type("0.95");
  await expect(page.locator(".number-problem")).toContainText("away from the nearest rotation");
  await page.keyboard.press("Alt+Enter");
  await expect(cell).toHaveAttribute("aria-invalid", "false");
  await expect(page.locator(".problem")).toHaveCount(0);
  const pitch = field(page, "pitch in degrees");
  await pitch.focus();
  await page.keyboard.press("Backspace");
  await expect(page.locator(".number-problem")).toHaveText("A number is missing here.");
  await expect(pitch).toHaveAccessibleDescription(/the \? stands for a missing number/);
  await page.keyboard.type("20");
  await expect(page.locator(".number-problem")).toHaveCount(0);
});

test("an untouched angle keeps the digits that it has", async ({ page }) => {
  await page.goto("/");
  await edit(page, "pitch in degrees", "20");
  await expect(quaternionField(page)).toHaveValue("ZYX 45°, 20°, 0°");
});
