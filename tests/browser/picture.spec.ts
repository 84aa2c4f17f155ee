// The picture: what it shows, and turning it by keyboard, mouse and touch.
import { readFile } from "node:fs/promises";
import {
  bodyOn,
  expect,
  fromX,
  matrix,
  numbersOf,
  press,
  quaternionField,
  stage,
  tabTo,
  test,
  violationsOf,
} from "./support/page.ts";

/** A quarter turn in steps of 5°. */
const quarter = 18;

test("turning the body to the right turns it about the axis that points up", async ({ page }) => {
  await page.goto(`/#read?quaternion=1+0+0+0&${fromX}`);
  await tabTo(page, stage(page));
  await press(page, "Shift+ArrowRight", quarter);
  // About z: the body's x axis points to the world's y.
  await expect(quaternionField(page)).toHaveValue("90deg about z");
  expect(await numbersOf(matrix(page, "R(q)"))).toEqual([0, -1, 0, 1, 0, 0, 0, 0, 1]);
});

test("turning it down turns it about the axis to the right, rolling about that to the eye", async ({
  page,
}) => {
  await page.goto(`/#read?quaternion=1+0+0+0&${fromX}`);
  await stage(page).focus();
  await press(page, "Shift+ArrowDown", quarter);
  // About y: x to −z.
  await expect(quaternionField(page)).toHaveValue("90deg about y");
  await quaternionField(page).fill("1 0 0 0");
  await stage(page).focus();
  await press(page, "PageUp", quarter);
  await expect(quaternionField(page)).toHaveValue("90deg about x");
});

test("what is written is the same turn in every convention", async ({ page }) => {
  for (const declared of [
    "as=jpl",
    "as=jpl&direction=body-to-world",
    "as=hamilton&direction=world-to-body",
  ]) {
    await page.goto(`/#read?quaternion=w%3D1+x%3D0+y%3D0+z%3D0&${declared}&${fromX}`);
    await stage(page).focus();
    await press(page, "Shift+ArrowRight", quarter);
    await expect(quaternionField(page)).toHaveValue("90deg about z");
    await expect.poll(() => numbersOf(matrix(page, "R(q)"))).toEqual([0, -1, 0, 1, 0, 0, 0, 0, 1]);
  }
});

test("dragging the body turns it, dragging beside it looks round", async ({ page }) => {
  await page.goto(`/#read?quaternion=1+0+0+0&${fromX}`);
  const box = await stage(page).boundingBox();
  if (!box) throw new Error("no picture");
  const [across, down] = [box.x + box.width / 2, box.y + box.height / 2 + 4];
  await page.mouse.move(across + 6, down + 10);
  await page.mouse.down();
  // 0.6° for each pixel.
  await page.mouse.move(across + 6 + 150, down + 10, { steps: 10 });
  await page.mouse.up();
  await expect(quaternionField(page)).toHaveValue("90deg about z");
  await expect(page).toHaveURL(/look=0,0/);

  await page.mouse.move(box.x + 20, box.y + 20);
  await page.mouse.down();
  await page.mouse.move(box.x + 20 + 50, box.y + 20, { steps: 5 });
  await page.mouse.up();
  await expect(page).toHaveURL(/look=-30,0/);
  await expect(quaternionField(page)).toHaveValue("90deg about z");
});

test("a drag and a turn by keys leave nothing to note", async ({ page }) => {
  await page.goto("/#read?quaternion=0.8+0.3+-0.2+0.5&decimals=6");
  const { x, y } = await bodyOn(page);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 37, y - 23, { steps: 5 });
  await page.mouse.up();
  await expect(quaternionField(page)).toHaveValue(/^[\d.]+deg about -?0\.\d+ -?0\.\d+ -?0\.\d+$/);
  await expect(page.getByText(/norm is/)).toHaveCount(0);
  const dragged = await quaternionField(page).inputValue();
  await stage(page).focus();
  await press(page, "Shift+ArrowUp", 3);
  await expect(quaternionField(page)).not.toHaveValue(dragged);
  await expect(page.getByText(/norm is/)).toHaveCount(0);
  // As it is said of four numbers that were rounded.
  await quaternionField(page).fill("0.707107 0 0 0.707107");
  await expect(page.getByText(/norm is/).first()).toBeVisible();
});

test("what the browser makes a scroll of is taken back", async ({ page }) => {
  await page.goto(`/#read?quaternion=1+0+0+0&${fromX}`);
  const { x, y } = await bodyOn(page);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 40, y + 30, { steps: 4 });
  await expect(quaternionField(page)).toHaveValue(/deg about /);
  await stage(page).dispatchEvent("pointercancel", { pointerId: 1, bubbles: true });
  await page.mouse.up();
  await expect(quaternionField(page)).toHaveValue("1 0 0 0");
});

test("active and passive: the vector moves, or the axes do", async ({ page }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await page.goto("/#read?quaternion=90deg+about+z&vector=1+0+0");
  const letters = () => stage(page).locator("text").allTextContents();
  await expect(stage(page)).toBeVisible();
  await expect
    .poll(async () => (await letters()).sort())
    .toEqual(["90°", "v", "xB", "xW", "yB", "yW", "zB", "zW"].sort());
  await expect(stage(page)).toHaveAccessibleDescription(
    /A rotation by 90° about z carries the world axes W onto the body axes B.*x axis points to \[0, 1, 0\].*The vector v is \[0, 1, 0\] on the world axes and \[1, 0, 0\] on the body axes/,
  );
  await page.getByRole("radio", { name: "Active" }).focus();
  await page.keyboard.press("Space");
  await expect
    .poll(async () => (await letters()).sort())
    .toEqual(["90°", "v", "v′", "xW", "yW", "zW"].sort());
  await expect(stage(page)).toHaveAccessibleDescription(
    /R\(q\) turns v into v′, and the body with it, by 90° about z.*along x now points to \[0, 1, 0\].*v = \[1, 0, 0\] becomes v′ = \[0, 1, 0\]/,
  );
  // JPL's C(q) of the same attitude turns a vector the other way.
  await page.getByRole("radio", { name: /^JPL/ }).check();
  await expect(stage(page)).toHaveAccessibleDescription(
    /C\(q\) turns v into v′, and the body with it, by 90° about −z.*along x now points to \[0, −1, 0\].*v = \[1, 0, 0\] becomes v′ = \[0, −1, 0\]/,
  );
  await expect(page).toHaveURL(/picture=active/);
});

test("turning the body of the active picture writes what turns it so", async ({ page }) => {
  // JPL's C(q) turns by the opposite of the attitude: to the right, about z, is an attitude about −z.
  await page.goto(`/#read?quaternion=0+0+0+1&as=jpl&picture=active&${fromX}`);
  await stage(page).focus();
  await press(page, "Shift+ArrowRight", quarter);
  await expect(quaternionField(page)).toHaveValue("90deg about -z");
  await expect(stage(page)).toHaveAccessibleDescription(
    /about z\. .*along x now points to \[0, 1, 0\]/,
  );
  expect(await numbersOf(matrix(page, "C(q)"))).toEqual([0, -1, 0, 1, 0, 0, 0, 0, 1]);
});

test("a drag is one step of undo, and Escape takes it back", async ({ page }) => {
  await page.goto(`/#read?quaternion=1+0+0+0&${fromX}`);
  const box = await stage(page).boundingBox();
  if (!box) throw new Error("no picture");
  const [across, down] = [box.x + box.width / 2 + 6, box.y + box.height / 2 + 14];
  const drag = async () => {
    await page.mouse.move(across, down);
    await page.mouse.down();
    await page.mouse.move(across + 40, down + 10, { steps: 5 });
  };
  await drag();
  await expect(quaternionField(page)).toHaveValue(/deg about /);
  await page.keyboard.press("Escape");
  await expect(quaternionField(page)).toHaveValue("1 0 0 0");
  await page.mouse.move(across + 80, down);
  await page.mouse.up();
  await expect(quaternionField(page)).toHaveValue("1 0 0 0");
  await drag();
  await page.mouse.up();
  await expect(quaternionField(page)).toHaveValue(/deg about /);
  await page.getByRole("button", { name: "Undo" }).click();
  await expect(quaternionField(page)).toHaveValue("1 0 0 0");
});

test("the picture of an earlier text looks like one", async ({ page }) => {
  await page.goto("/#read?quaternion=90deg+about+z");
  await stage(page).waitFor();
  await expect(page.locator(".picture-old")).toHaveCount(0);
  await quaternionField(page).fill("90deg about");
  await expect(page.locator(".picture-old")).toBeVisible();
});

test("the change of reading is shown once, and at once for those who want less motion", async ({
  page,
}) => {
  const frames = async () => {
    await page.goto("/#read?quaternion=90deg+about+z&vector=1+0+0");
    await stage(page).waitFor();
    await page.evaluate(() => {
      const drawing = document.querySelector(".stage svg");
      const seen = new Set<string>();
      Object.assign(globalThis, { seen });
      new MutationObserver(() => seen.add(drawing?.innerHTML ?? "")).observe(drawing as Element, {
        attributes: true,
        childList: true,
        subtree: true,
      });
    });
    await page.getByRole("radio", { name: "Active" }).check();
    const shaft = stage(page).locator("line[stroke='var(--picture-accent)']").last();
    await expect(shaft).toBeAttached();
    const count = () =>
      page.evaluate(() => (globalThis as unknown as { seen: Set<string> }).seen.size);
    let last = -1;
    // Until nothing changes between two looks.
    await expect
      .poll(
        async () => {
          const now = await count();
          const isStill = now === last;
          last = now;
          return isStill;
        },
        { intervals: [300] },
      )
      .toBe(true);
    return last;
  };
  expect(await frames()).toBeGreaterThan(5);
  await page.emulateMedia({ reducedMotion: "reduce" });
  await page.goto("about:blank");
  expect(await frames()).toBeLessThanOrEqual(2);
});

test("the same numbers under the other product are a second pose", async ({ page }) => {
  await page.goto("/#read?quaternion=90deg+about+z");
  await page.getByRole("checkbox", { name: "Also as JPL body → world" }).check();
  await expect(stage(page)).toHaveAccessibleDescription(
    /^Dashed: the same four numbers read as JPL, body → world: the opposite rotation/,
  );
  const letters = await stage(page).locator("text").allTextContents();
  expect(letters).toEqual(expect.arrayContaining(["xH", "xJ", "yH", "yJ", "zH", "zJ"]));
  await quaternionField(page).fill("180deg about z");
  await expect(stage(page)).toHaveAccessibleDescription(/are the same pose/);
});

test("the picture is saved as an SVG that needs nothing else", async ({ page }) => {
  await page.emulateMedia({ colorScheme: "dark" });
  await page.goto(`/#read?quaternion=90deg+about+z&vector=1+0+0&${fromX}`);
  const saving = page.waitForEvent("download");
  await page.getByRole("button", { name: "Save SVG" }).click();
  const download = await saving;
  expect(download.suggestedFilename()).toBe("quatlas-rotation.svg");
  const text = await readFile(await download.path(), "utf8");
  expect(text).toMatch(/^<svg[^>]*xmlns="http:\/\/www\.w3\.org\/2000\/svg"/);
  expect(text).toContain("<title>Picture of the rotation</title>");
  expect(text).toMatch(/<desc>A rotation by 90° about z carries/);
  expect(text).not.toMatch(/var\(|class=| style=|NaN|undefined|href|script/);
  const opened = await page.evaluate((source) => {
    const { documentElement } = new DOMParser().parseFromString(source, "image/svg+xml");
    return [documentElement.nodeName, documentElement.querySelectorAll("line").length];
  }, text);
  expect(opened[0]).toBe("svg");
  expect(opened[1]).toBeGreaterThan(50);
});

test("a picture without a turn, or without a vector, is one without its parts", async ({
  page,
}) => {
  await page.goto("/#read?quaternion=1+0+0+0&vector=0+0+0");
  await expect(stage(page)).toHaveAccessibleDescription(/^No rotation/);
  expect(await stage(page).locator("text").allTextContents()).not.toContain("x");
});

test("compose: step by step about fixed and about moving axes, to one pose", async ({ page }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await page.goto("/#compose?p=90deg+about+z&q=90deg+about+x");
  const fixed = page.getByRole("application", {
    name: "Picture of the rotations about fixed axes",
  });
  const moving = page.getByRole("application", {
    name: "Picture of the rotations about moving axes",
  });
  const body = (which: typeof fixed) =>
    which
      .locator(".picture-body path")
      .evaluateAll((paths) => paths.map((path) => path.getAttribute("d")));
  await expect(fixed).toHaveAccessibleDescription(
    /q: 90° about x of the world\. p: 90° about z of the world/,
  );
  await expect(moving).toHaveAccessibleDescription(
    /p: 90° about z of the body\. q: 90° about x of the body/,
  );
  expect(await body(fixed)).toEqual(await body(moving));
  await page.getByRole("radio", { name: "First rotation" }).focus();
  await page.keyboard.press("Space");
  await expect(fixed).toHaveAccessibleDescription(/^q: 90° about x of the world\. Drag/);
  await expect(moving).toHaveAccessibleDescription(/^p: 90° about z of the body\. Drag/);
  expect(await body(fixed)).not.toEqual(await body(moving));
  await page.keyboard.press("ArrowLeft");
  await expect(fixed).toHaveAccessibleDescription(/^The body stands on the world axes/);
  expect(await body(fixed)).toEqual(await body(moving));
  await page.getByRole("button", { name: "Play" }).press("Enter");
  await expect(page.getByRole("radio", { name: "Both rotations" })).toBeChecked();
  // JPL p ⊗ q: first p about fixed axes.
  await page.getByRole("radio", { name: /^JPL/ }).check();
  await expect(fixed).toHaveAccessibleDescription(
    /p: 90° about z of the world\. q: 90° about x of the world/,
  );
});

test("axe finds nothing on either picture", async ({ page }) => {
  await page.goto("/#read?poses=both");
  await stage(page).waitFor();
  expect(await violationsOf(page)).toEqual([]);
  await page.goto("/#compose");
  await page.getByRole("application").first().waitFor();
  expect(await violationsOf(page)).toEqual([]);
});
