// What is said of an input, and the key that mends it.
import type { Page } from "@playwright/test";
import {
  expect,
  holdBack,
  matrix,
  numbersOf,
  quaternionField,
  sidewaysScroll,
  tabTo,
  test,
  violationsOf,
} from "./support/page.ts";

const notes = (page: Page) => page.locator(".notes li");
const fix = (page: Page, name: string | RegExp) => page.getByRole("button", { name });

async function type(page: Page, text: string) {
  await quaternionField(page).fill(text);
  await quaternionField(page).focus();
}

/** Rows of a matrix as they are written. */
const rows = (...numbers: string[]) => numbers.join("\n");

/** A text, what is said of it, and the text that the key writes. */
const texts: { name: string; typed: string; said: RegExp; written: string }[] = [
  {
    name: "a norm that is not 1",
    typed: "quaternion w=3 x=0 y=0 z=-4",
    said: /The norm is 5, off from 1 by 4/,
    written: "w=0.6 x=0 y=0 z=-0.8",
  },
  {
    name: "a negative scalar",
    typed: "-0.6 + 0.64i - 0.48k",
    said: /The scalar is negative: −q is the same rotation/,
    written: "w=0.6 x=-0.64 y=0 z=0.48",
  },
  {
    name: "angles that seem to be degrees",
    typed: "ZYX 30 20 10",
    said: /read as degrees/,
    written: "ZYX 30 20 10 deg",
  },
  {
    name: "angles that seem to be radians",
    typed: "0.5 about [0, 3, 4]",
    said: /read as radians/,
    written: "0.5 deg about [0, 3, 4]",
  },
  {
    name: "nine numbers in a row",
    typed: "0 -1 0 1 0 0 0 0 1",
    said: /read row by row.*180° away/,
    written: rows("0 1 0", "-1 0 0", "0 0 1"),
  },
  {
    name: "three axes by name",
    typed: "x: 0 1 0, y: -1 0 0, z: 0 0 1",
    said: /read as the columns.*180° away/,
    written: rows("0 1 0", "-1 0 0", "0 0 1"),
  },
  {
    name: "a matrix that is not quite orthogonal",
    typed: rows("0 -1.01 0", "1 0 0", "0 0 1"),
    said: /not quite a rotation.*0\.02\d*\).*0\.01\d* away/,
    written: rows("0 -1 0", "1 0 0", "0 0 1"),
  },
];

for (const { name, typed, said, written } of texts) {
  test(`${name}: said, and mended with one key`, async ({ page }) => {
    await page.goto("/");
    await type(page, typed);
    await expect(notes(page)).toHaveText([said]);
    const button = page.locator(".notes .fix").first();
    await expect(button).toHaveAttribute("aria-keyshortcuts", "Alt+Enter");
    const label = await button.locator(".fix-label").innerText();
    await page.keyboard.press("Alt+Enter");
    await expect(quaternionField(page)).toHaveValue(written);
    await expect(notes(page)).toHaveCount(0);
    await expect(page.getByRole("status")).toHaveText(new RegExp(`^Done: .*${label.slice(-8)}`));
  });
}

test("the order of bare numbers is declared with one key, and back", async ({ page }) => {
  await page.goto("/");
  await type(page, "0.6 0 0 0.8");
  await expect(notes(page)).toHaveText([/read as w x y z/]);
  await expect
    .poll(() => numbersOf(matrix(page, "R(q)")))
    .toEqual([-0.28, -0.96, 0, 0.96, -0.28, 0, 0, 0, 1]);
  await page.keyboard.press("Alt+Enter");
  // A turn about x now: the scalar is the last number.
  await expect
    .poll(() => numbersOf(matrix(page, "R(q)")))
    .toEqual([1, 0, 0, 0, 0.28, -0.96, 0, 0.96, 0.28]);
  await expect(notes(page)).toHaveText([/read as x y z w/]);
  await expect(quaternionField(page)).toHaveValue("0.6 0 0 0.8");
  await page.keyboard.press("Alt+Enter");
  await expect(page.getByRole("radio", { name: /^Hamilton/ })).toBeChecked();
});

test("a constructor of the other order: its order is declared", async ({ page }) => {
  await page.goto("/");
  await type(page, "R.from_quat([0, 0, 0.6, 0.8])");
  await expect(notes(page)).toHaveText([
    /^The order in the text, by its constructor, is x y z w, not the declared one; the text wins\./,
  ]);
  const before = await numbersOf(matrix(page, "R(q)"));
  await tabTo(page, fix(page, "Declare x y z w"));
  await page.keyboard.press("Enter");
  await expect(notes(page)).toHaveCount(0);
  await expect(quaternionField(page)).toBeFocused();
  expect(await numbersOf(matrix(page, "R(q)"))).toEqual(before);
});

test("what settles something comes before what declares", async ({ page }) => {
  await page.goto("/");
  await type(page, "quaternion -3 0 0 4");
  await expect(notes(page)).toHaveCount(3);
  await page.keyboard.press("Alt+Enter");
  await expect(quaternionField(page)).toHaveValue("w=-0.6 x=0 y=0 z=0.8");
  await page.keyboard.press("Alt+Enter");
  await expect(quaternionField(page)).toHaveValue("w=0.6 x=0 y=0 z=-0.8");
  // There is nothing to mend now, and the key does nothing.
  await page.keyboard.press("Alt+Enter");
  await expect(quaternionField(page)).toHaveValue("w=0.6 x=0 y=0 z=-0.8");
});

test("the key does what the button says that shows it, and the list of keys says so", async ({
  page,
}) => {
  await page.goto("/");
  await type(page, "0.02 -0.01 0.38 0.92");
  // The first of the two would declare another order.
  await expect(page.locator(".notes .fix-label")).toHaveText(["Read as x y z w", "Write q/|q|"]);
  await expect(page.locator(".fix", { hasText: "Alt+Enter" })).toHaveText(/^Write q\/\|q\|/);
  await expect(page.locator("[aria-keyshortcuts='Alt+Enter']")).toHaveCount(1);
  await page.keyboard.press("Alt+Enter");
  await expect(quaternionField(page)).toHaveValue(/^w=0\.020087/);
  await expect(page).not.toHaveURL(/order=/);
  await page.getByRole("button", { name: "Keyboard shortcuts" }).click();
  const row = page.locator(".shortcuts div", { hasText: "Alt+Enter" });
  await expect(row.getByRole("definition")).toHaveText(/as the button says that shows these keys/);
});

test("the other unit by its own button, and the focus goes to the text", async ({ page }) => {
  await page.goto("/");
  await type(page, "ZYX 30 20 10");
  await tabTo(page, fix(page, "These are degrees"));
  await page.keyboard.press("Enter");
  await expect(quaternionField(page)).toHaveValue("ZYX 30 20 10 deg");
  await expect(quaternionField(page)).toBeFocused();
});

test("nearly no turn and nearly half a turn stand beside axis and angle", async ({ page }) => {
  await page.goto("/");
  const turn = page.locator(".fact", { hasText: "Axis and angle" });
  await type(page, "rotvec 0 0 0.00005");
  await expect(turn).toContainText("Nearly no rotation, 0.0029° (0.00005 rad)");
  await expect(turn).toContainText("off by up to 2°");
  await type(page, "179.9995° about x");
  await expect(turn).toContainText("Nearly half a turn, short of it by 0.0005°");
  await type(page, "180° about x");
  await expect(turn).toContainText("the axis and its opposite are equally right");
  await type(page, "1 + 0k");
  await expect(turn).toContainText("This is the identity: no rotation.");
  await type(page, "90° about x");
  await expect(turn.locator(".note-beside")).toHaveCount(0);
});

test("the other sign is the same rotation, and can be written", async ({ page }) => {
  await page.goto("/#read?quaternion=0.6+%2B+0.8k");
  const card = page.locator(".fact", { hasText: "The other sign" });
  await expect(card).toContainText("The same rotation, not its inverse.");
  const before = await numbersOf(matrix(page, "R(q)"));
  await card.getByRole("button", { name: "Write −q" }).focus();
  await page.keyboard.press("Enter");
  await expect(quaternionField(page)).toHaveValue("w=-0.6 x=0 y=0 z=-0.8");
  expect(await numbersOf(matrix(page, "R(q)"))).toEqual(before);
  await expect(page.getByRole("status")).toHaveText(/^Done: Write −q/);
});

test("near gimbal lock the distance is said, with what it does", async ({ page }) => {
  await page.goto("/");
  await type(page, "ZYX 30° 89.9° 10°");
  await expect(page.locator(".gimbal-lock")).toContainText("0.1° from it");
  await expect(page.locator(".gimbal-lock")).toContainText("570 times as large");
});

test("gimbal lock says which angle is lost, what survives, and how far it is", async ({ page }) => {
  await page.goto("/");
  await type(page, "ZYX 30° 90° 10°");
  const lock = page.locator(".gimbal-lock");
  await expect(lock).toHaveText(/^Gimbal lock: .*only yaw − roll = 20/);
  await expect(lock).toContainText(/(roll|yaw) is set to 0/);
});

/** A text with a problem, what is said of it, and what the key writes in its place. */
const problems: [typed: string, said: RegExp, label: string, written: string][] = [
  ["[0.6, 0, 0, 0.8", /the bracket \[ is never closed/, "Fix the brackets", "[0.6, 0, 0, 0.8]"],
  [
    "0,6 0 0 0,8",
    /commas between some numbers, only spaces between others/,
    "Write decimal points",
    "0.6 0 0 0.8",
  ],
  ["0.6，0，0，0.8", /unexpected character ，/, "Write plain characters", "0.6,0,0,0.8"],
  ["0.6 0.8k", /missing \+ or - before this term/, "Add the sign", "0.6 + 0.8k"],
  ["w=0.6 z=0.8", /x, y are missing/, "Write 0 for what is missing", "w=0.6 z=0.8 x=0 y=0"],
  [
    "0 0 0 0",
    /all four components are zero: this is not a rotation/,
    "Write the identity",
    "w=1 x=0 y=0 z=0",
  ],
  [
    "1 0 0 0 1 0 0 0 -1",
    /this matrix is a reflection, not a rotation: the z axis is flipped/,
    "Flip the axis",
    rows("1 0 0", "0 1 0", "0 0 1"),
  ],
  [
    rows("0 -1 0", "1 0 0", "0 0 1.5"),
    /the columns of this matrix are those of a rotation times 1, 1 and 1\.5/,
    "Write the nearest rotation",
    rows("0 -1 0", "1 0 0", "0 0 1"),
  ],
];

for (const [typed, said, label, written] of problems) {
  test(`${label}: one key and by the button`, async ({ page }) => {
    await page.goto("/");
    await type(page, typed);
    await expect(page.locator(".problem-message")).toHaveText(said);
    await page.keyboard.press("Alt+Enter");
    await expect(quaternionField(page)).toHaveValue(written);
    await expect(quaternionField(page)).toHaveAttribute("aria-invalid", "false");
    await expect(page.getByRole("status")).toHaveText(new RegExp(`^Done: ${label}\\.`));

    await type(page, typed);
    await tabTo(page, fix(page, label));
    await page.keyboard.press("Enter");
    await expect(quaternionField(page)).toHaveValue(written);
    await expect(quaternionField(page)).toBeFocused();
  });
}

test("a problem that can only be guessed offers nothing", async ({ page }) => {
  await page.goto("/");
  await type(page, "1 2 3");
  await expect(page.locator(".problem-message")).toHaveText(/3 numbers: a quaternion has 4/);
  await expect(page.locator(".fix", { hasText: "Alt" })).toHaveCount(0);
  await page.keyboard.press("Alt+Enter");
  await expect(quaternionField(page)).toHaveValue("1 2 3");
});

test("the vector is mended too, and by a key that comes before it is known how", async ({
  page,
}) => {
  await page.goto("/");
  const allow = await holdBack(page, "**/quatlas_bg-*.wasm");
  const vector = page.getByRole("textbox", { name: "vector v" });
  await vector.fill("0,5 0 0,5");
  await vector.focus();
  await expect(page.getByText("Reading …")).toBeVisible();
  await page.keyboard.press("Alt+Enter");
  await expect(vector).toHaveValue("0,5 0 0,5");
  allow();
  await expect(vector).toHaveValue("0.5 0 0.5");
});

test("in Compose each operand has its own key", async ({ page }) => {
  await page.goto("/#compose?p=qw%3D3+qx%3D0+qy%3D0+qz%3D4&q=-0.6+%2B+0.8i");
  const p = page.getByRole("textbox", { name: "quaternion p" });
  const q = page.getByRole("textbox", { name: "quaternion q" });
  const lines = page.locator(".read-as > div");
  await expect(lines).toHaveText([/^p .*The norm is 5/, /^q .*The scalar is negative/]);
  await expect(fix(page, "Write p/|p|")).toBeVisible();
  await q.focus();
  await page.keyboard.press("Alt+Enter");
  await expect(q).toHaveValue("w=0.6 x=-0.8 y=0 z=0");
  await expect(p).toHaveValue("qw=3 qx=0 qy=0 qz=4");
  await p.focus();
  await page.keyboard.press("Alt+Enter");
  await expect(p).toHaveValue("w=0.6 x=0 y=0 z=0.8");
  await expect(notes(page)).toHaveCount(0);
});

test("in Translate a text is mended in its own field", async ({ page }) => {
  await page.goto("/#translate");
  await type(page, "[0.1, -0.2, 0.4, 0.9");
  await page.keyboard.press("Alt+Enter");
  await expect(quaternionField(page)).toHaveValue("[0.1, -0.2, 0.4, 0.9]");
});

test("nothing below moves when notes and problems come", async ({ page }) => {
  await page.goto("/");
  const top = () => page.locator(".result").evaluate((node) => (node as HTMLElement).offsetTop);
  const before = await top();
  for (const text of ["0.6 0 0 0.8", "3 0 0 4", "0.6 0.8k", "[0.6, 0, 0, 0.8", "0 0 0 0"]) {
    await type(page, text);
    expect(await top(), text).toBe(before);
    // Where there is less room for them they take it after a rest: first_screen.spec.ts.
    await page.setViewportSize({ width: 360, height: 900 });
    expect(await sidewaysScroll(page), text).toBeLessThanOrEqual(0);
    await page.setViewportSize({ width: 1280, height: 900 });
  }
});

test("a button that fixes a text is as high as a finger or an unsteady hand needs", async ({
  page,
}) => {
  for (const text of ["3 0 0 4", "[0.6, 0, 0, 0.8"]) {
    await page.goto("/");
    await type(page, text);
    const buttons = page.locator(".ask-status .fix");
    await expect(buttons.first()).toBeVisible();
    for (const { height } of await buttons.evaluateAll((found) =>
      found.map((button) => button.getBoundingClientRect()),
    ))
      expect(height).toBeGreaterThanOrEqual(24);
  }
});

test("notes with their buttons have no violations", async ({ page }) => {
  await page.goto("/#read?quaternion=-3+0+0+4");
  await expect(notes(page)).toHaveCount(3);
  expect(await violationsOf(page)).toEqual([]);
});

test("a problem with its button has no violations", async ({ page }) => {
  await page.goto("/#read?quaternion=1+0+0+0+1+0+0+0+-1");
  await expect(fix(page, /^Flip the axis/)).toBeVisible();
  expect(await violationsOf(page)).toEqual([]);
});

test("nothing moves when an angle comes to gimbal lock", async ({ page }) => {
  await page.goto("/#read?quaternion=ZYX+30%C2%B0+20%C2%B0+10%C2%B0");
  // It is said in the last row of the answer: what is above it stays.
  const end = () =>
    page.locator(".fact-euler").evaluate((node) => node.getBoundingClientRect().top + scrollY);
  await expect(page.locator(".fact-euler")).toBeVisible();
  const before = await end();
  for (const pitch of ["90", "89.9999"]) {
    await quaternionField(page).fill(`ZYX 30° ${pitch}° 10°`);
    await expect(page.locator(".fact-euler")).toContainText(/gimbal lock/i);
    expect(await end(), pitch).toBe(before);
  }
});
