// Settings that are remembered, the theme, the keys, and how the page looks in other surroundings.
import type { Page } from "@playwright/test";
import { table } from "../../www/action/shortcuts.ts";
import { fromFragment, toFragment } from "../../www/address/fragment.ts";
import { opening } from "../../www/model/page_state.ts";
import { fromRadians, shownAngle, shownRoughAngle } from "../../www/number/format.ts";
import { shortcutWords } from "../../www/words/frame/help.ts";
import {
  expect,
  matrix,
  numbersOf,
  part,
  quaternionField,
  sidewaysScroll,
  tab,
  tabTo,
  test,
  violationsOf,
} from "./support/page.ts";

const radio = (page: Page, name: string) => page.getByRole("radio", { name, exact: true });
const paper = (page: Page) => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
const light = "rgb(247, 246, 242)";
const dark = "rgb(17, 20, 25)";

test("angles are shown in degrees or radians, as exactly as they are known", () => {
  const angle = fromRadians(Math.PI / 6);
  expect(angle.degrees).toBe(30);
  expect(shownAngle(angle, "6", "degrees")).toBe("30°");
  expect(shownAngle(angle, "4", "radians")).toBe("0.5236\u00a0rad");
  expect(shownAngle(angle, "all", "radians")).toBe("0.5235987755982988\u00a0rad");
  expect(shownAngle({ degrees: -90, radians: -1.5 }, "6", "degrees")).toBe("−90°");
  expect(shownRoughAngle(53.13010235, "degrees")).toBe("53.1°");
  expect(shownRoughAngle(53.13010235, "radians")).toBe("0.927\u00a0rad");
});

test("the address holds the unit, and no other word is one", () => {
  const radians = { ...opening, unit: "radians" } as const;
  expect(toFragment(radians)).toBe("read?v=1&unit=rad");
  expect(fromFragment("read?unit=rad")).toEqual(radians);
  for (const other of ["deg", "radians", "__proto__", ""]) {
    expect(fromFragment(`read?unit=${other}`)).toEqual(opening);
  }
});

test("the unit of angles follows the choice wherever an angle stands, and the address", async ({
  page,
}) => {
  await page.goto("/#read?quaternion=ZYX 30° 90° 10°");
  await tabTo(page, radio(page, "degrees"));
  await page.keyboard.press("ArrowRight");
  await expect(radio(page, "radians")).toBeChecked();
  await expect(page).toHaveURL(/unit=rad/);
  // 30°, 90°, 10°; the surviving difference is 20°.
  await expect(page.locator(".read-as")).toContainText("0.523599 rad, 1.570796 rad, 0.174533 rad");
  await expect(page.locator(".gimbal-lock")).toContainText("yaw − roll = 0.349066 rad");
  await expect(page.getByRole("status")).toContainText("a rotation by 1.600955 rad about");

  await page.goto("/#translate?unit=rad&translated=0 0 0.6 0.8&from=openvins&to=eigen");
  await expect(page.locator(".mistake-angle").first()).toContainText("rad off");
  await expect(page.locator(".mistakes")).not.toContainText("°");
  // (0, 0, 0.6, 0.8) in one order times itself in the other: 2 arccos 0.48.
  await page.goto("/#read?unit=rad&quaternion=0 0 0.6 0.8");
  await expect(page.locator(".notes")).toContainText("a rotation 2.14 rad away");
});

test("the theme that is chosen in one tab is that of the others", async ({ page, context }) => {
  await page.emulateMedia({ colorScheme: "light" });
  await page.goto("/");
  const another = await context.newPage();
  await another.goto("/");
  await another.getByRole("button", { name: /^Theme/ }).click();
  await another.close();
  await expect(page.getByRole("button", { name: "Theme: dark" })).toBeVisible();
  expect(await paper(page)).toBe(dark);
});

test("a bare address remembers the numbers' settings, a link does not", async ({ page }) => {
  await page.goto("/");
  await radio(page, "4").check();
  await radio(page, "radians").check();
  await page.goto("about:blank");
  await page.goto("/");
  await expect(radio(page, "4")).toBeChecked();
  await expect(radio(page, "radians")).toBeChecked();
  expect((await numbersOf(matrix(page, "R(q)")))[0]).toBe(0.7071);
  // The link says neither, so both are as at the opening.
  await page.goto("about:blank");
  await page.goto("/#read?quaternion=1+0+0+1");
  await expect(radio(page, "6")).toBeChecked();
  await expect(radio(page, "degrees")).toBeChecked();
});

test("former and foreign values in the storage, and none at all, are no settings", async ({
  page,
}) => {
  await page.addInitScript(() => {
    localStorage.setItem("quatlas-digits", "9");
    localStorage.setItem("quatlas-unit", '{"unit":');
    localStorage.setItem("quatlas-theme", "__proto__");
    localStorage.setItem("quatlas-shortcuts", "");
  });
  await page.goto("/");
  await expect(radio(page, "6")).toBeChecked();
  await expect(radio(page, "degrees")).toBeChecked();
  await expect(page.getByRole("button", { name: "Theme: as the system" })).toBeVisible();
});

test("a browser that refuses to store keeps the choice for the visit", async ({ page }) => {
  await page.addInitScript(() => {
    Object.defineProperty(window, "localStorage", {
      get: () => {
        throw new DOMException("denied", "SecurityError");
      },
    });
  });
  await page.goto("/");
  await radio(page, "all").check();
  await page.getByRole("button", { name: "Theme: as the system" }).click();
  await expect(page.getByRole("button", { name: "Theme: dark" })).toBeVisible();
  expect(await paper(page)).toBe(dark);
});

test("the theme is the system's or by hand, from the first paint on", async ({ page }) => {
  await page.emulateMedia({ colorScheme: "light" });
  await page.goto("/");
  const frame = () =>
    page.evaluate(() =>
      [...document.querySelectorAll<HTMLMetaElement>("meta[name=theme-color]")]
        .filter(({ media }) => matchMedia(media).matches)
        .map(({ content }) => content),
    );
  expect(await paper(page)).toBe(light);
  expect(await frame()).toEqual(["#f7f6f2"]);
  await page.getByRole("button", { name: "Theme: as the system" }).click();
  expect(await paper(page)).toBe(dark);
  expect(await frame()).toEqual(["#111419"]);
  await expect(page).not.toHaveURL(/dark/);

  // Before the script of the page runs, the remembered theme is there.
  await page.route("**/*.wasm", () => {});
  await page.goto("/#read");
  await page.reload({ waitUntil: "commit" });
  await expect(matrix(page, "R(q)")).toBeVisible();
  expect(await paper(page)).toBe(dark);
  await page.unroute("**/*.wasm");
  await page.reload();

  await page.getByRole("button", { name: "Theme: dark" }).click();
  await page.emulateMedia({ colorScheme: "dark" });
  expect(await paper(page)).toBe(light);
  await page.getByRole("button", { name: "Theme: light" }).click();
  await expect(page.locator("html")).toHaveAttribute("data-theme", "dark");
  await page.getByRole("button", { name: "Theme: dark" }).click();
  await expect(page.locator("html")).not.toHaveAttribute("data-theme");
  await page.emulateMedia({ colorScheme: "light" });
  expect(await paper(page)).toBe(light);
});

test("every key of the list does what the list says", async ({ page, context }) => {
  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  await page.goto("/#read?quaternion=0 0 0.6 0.8");
  await expect(matrix(page, "R(q)")).toBeVisible();
  const key = (name: string) => page.keyboard.press(name);

  await key("j");
  await expect(page.getByRole("radio", { name: /^JPL/ })).toBeChecked();
  await key("c");
  await expect
    .poll(() => page.evaluate(() => navigator.clipboard.readText()))
    .toContain("0, 0, 0.6, 0.8");
  await key("h");
  await expect(page.getByRole("radio", { name: /^Hamilton/ })).toBeChecked();
  await key("d");
  await expect(radio(page, "all")).toBeChecked();
  await expect(page.getByText("Decimals: all")).toBeAttached();
  await key("u");
  await expect(radio(page, "radians")).toBeChecked();
  await key("t");
  await expect(page.getByRole("button", { name: "Theme: dark" })).toBeVisible();
  await key("e");
  await expect(page.getByRole("dialog", { name: "Examples" })).toBeVisible();
  await key("Escape");
  await key("?");
  await expect(page.getByRole("dialog", { name: "Keyboard shortcuts" })).toBeVisible();
  await key("Escape");
  const places = [
    ["Read", ["1"], ["g", "r"]],
    ["Compose", ["2"], ["g", "c"]],
    // The tab opens on its first part, and then on the one that was used last.
    ["Motion", ["3"], ["g", "m"]],
    ["Frames", ["4"], ["g", "f"]],
    ["Translate", ["5"], ["g", "t"]],
    ["Identify", ["g", "i"], ["5"]],
    ["All libraries", ["g", "l"], ["5"]],
  ] as const;
  for (const [name, ...ways] of places) {
    const link = tab(page, name).or(part(page, name));
    for (const way of ways) {
      for (const pressed of way) await key(pressed);
      await expect(link).toHaveAttribute("aria-current", "page");
      await expect(page.locator("main textarea, main input[type=search]").first()).toBeVisible();
      await key("/");
      await expect(page.locator("textarea:focus, input[type=search]:focus")).toBeVisible();
      await page.evaluate(() => (document.activeElement as HTMLElement).blur());
      await key("1");
      await expect(tab(page, "Read")).toHaveAttribute("aria-current", "page");
    }
  }
  // As with the links, going back returns.
  await page.goBack();
  await expect(part(page, "All libraries")).toHaveAttribute("aria-current", "page");
  // By the page's own history: the driver may not know yet that it went back.
  await page.evaluate(() => history.forward());
  await expect(quaternionField(page)).toHaveValue("0 0 0.6 0.8");
});

test("the list of keys is the table, keeps the focus inside and gives it back", async ({
  page,
}) => {
  await page.goto("/");
  const opener = page.getByRole("button", { name: "Keyboard shortcuts" });
  await tabTo(page, opener);
  await page.keyboard.press("Enter");
  const dialog = page.getByRole("dialog", { name: "Keyboard shortcuts" });
  const names = dialog.getByRole("definition");
  await expect(names.first()).toBeVisible();
  expect((await names.allTextContents()).slice(0, table.length)).toEqual(
    table.map(({ name }) => shortcutWords[name]),
  );
  const keys = await dialog.locator("dt").allTextContents();
  expect(keys.slice(0, table.length)).toEqual(
    table.map(({ keys }) => keys.map((key) => key.replace(" ", " then ")).join(" or ")),
  );
  for (let presses = 0; presses < 8; presses += 1) {
    await page.keyboard.press("Tab");
    const isOutside = await page.evaluate(
      () => document.activeElement?.closest("main, .masthead") !== null,
    );
    expect(isOutside).toBe(false);
  }
  await page.keyboard.press("Escape");
  await expect(dialog).toBeHidden();
  await expect(opener).toBeFocused();
});

test("a key right after Escape opens what it names: a closing told late closes nothing else", async ({
  page,
}) => {
  await page.goto("/");
  await expect(matrix(page, "R(q)")).toBeVisible();
  for (const [key, name] of [
    ["e", "Examples"],
    ["?", "Keyboard shortcuts"],
    ["?", "Keyboard shortcuts"],
    ["e", "Examples"],
  ] as const) {
    // As after Escape: closed, and the next key is there before the browser says so.
    await page.evaluate((key) => {
      const dialog = document.querySelector("dialog");
      // The focus is still there until the next frame.
      const focused = dialog?.querySelector("button") ?? document.body;
      dialog?.close();
      focused.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true }));
    }, key);
    const dialog = page.getByRole("dialog", { name });
    await expect(dialog.getByRole("link").or(dialog.getByRole("definition")).first()).toBeVisible();
    await expect(page.locator("dialog")).toHaveCount(1);
  }
  await page.keyboard.press("Escape");
  await expect(page.locator("dialog")).toHaveCount(0);
});

test("keys are letters in a text field, with a modifier, and once they are switched off", async ({
  page,
}) => {
  await page.goto("/");
  await expect(matrix(page, "R(q)")).toBeVisible();
  const field = quaternionField(page);
  await page.keyboard.press("/");
  await expect(field).toBeFocused();
  await page.keyboard.type("j?t2");
  await expect(field).toHaveValue("j?t2");
  await expect(page.getByRole("radio", { name: /^Hamilton/ })).toBeChecked();
  await expect(page.getByRole("dialog")).toHaveCount(0);

  await radio(page, "6").focus();
  await page.keyboard.press("Control+j");
  await page.keyboard.press("Alt+2");
  await expect(page.getByRole("radio", { name: /^Hamilton/ })).toBeChecked();

  await page.keyboard.press("?");
  const dialog = page.getByRole("dialog", { name: "Keyboard shortcuts" });
  await dialog.getByRole("radio", { name: "off" }).check();
  await page.keyboard.press("Escape");
  await page.reload();
  await radio(page, "6").focus();
  await page.keyboard.press("j");
  await page.keyboard.press("?");
  await expect(page.getByRole("radio", { name: /^Hamilton/ })).toBeChecked();
  await expect(page.getByRole("dialog")).toHaveCount(0);
});

test("a part that cannot be loaded says so", async ({ page }) => {
  await page.goto("/");
  await expect(matrix(page, "R(q)")).toBeVisible();
  await page.route("**/Gallery-*.js", (route) =>
    route.fulfill({ contentType: "text/javascript", body: "throw new Error('cut off')" }),
  );
  await page.keyboard.press("e");
  await expect(page.getByRole("dialog").getByRole("alert")).toContainText("could not be loaded");
});

const views = ["read", "compose", "translate", "identify", "libraries?find=jpl"];

for (const colorScheme of ["light", "dark"] as const) {
  for (const key of ["?", "e"]) {
    test(`no accessibility violation in the dialog of ${key}: ${colorScheme}`, async ({ page }) => {
      await page.emulateMedia({ colorScheme });
      await page.setViewportSize({ width: 320, height: 740 });
      await page.goto("/");
      await expect(matrix(page, "R(q)")).toBeVisible();
      await page.keyboard.press(key);
      await expect(page.getByRole("dialog").locator("dd, a").first()).toBeVisible();
      expect(await violationsOf(page)).toEqual([]);
      expect(await sidewaysScroll(page)).toBeLessThanOrEqual(0);
    });
  }
}

for (const view of views) {
  test(`no accessibility violation in forced colours: ${view}`, async ({ page }) => {
    test.slow();
    await page.emulateMedia({ forcedColors: "active" });
    await page.goto(`/#${view}`);
    await expect(page.locator(".views [aria-current=page]")).toBeVisible();
    await expect(page.locator("main .loading")).toHaveCount(0);
    expect(await violationsOf(page)).toEqual([]);
  });
}

test("on a phone no number is broken, a wide matrix shows that it goes on, a long name ends", async ({
  page,
}) => {
  await page.setViewportSize({ width: 320, height: 740 });
  await page.goto("/#translate?digits=all");
  const numbers = page.locator(".translation-end dd");
  await expect(numbers).toHaveCount(8);
  const heights = await numbers.evaluateAll((all) => all.map((one) => one.clientHeight));
  expect(new Set(heights).size).toBe(1);
  expect(await sidewaysScroll(page)).toBeLessThanOrEqual(0);

  const scrolled = page.locator(".matrix-scroll").first();
  expect(await scrolled.evaluate((node) => node.scrollWidth > node.clientWidth)).toBe(true);
  await expect(page.locator(".side-scroll").first()).toHaveAttribute("data-hidden", "right");

  await page.goto(`/#identify?name=${"aVeryLongName".repeat(20)}`);
  const name = page.locator(".answer h2");
  await expect(name).toBeVisible();
  expect(await name.evaluate((node) => node.clientHeight)).toBeLessThan(70);
});

test("what only colours say is said by lines where colours are forced", async ({ page }) => {
  await page.emulateMedia({ forcedColors: "active" });
  await page.goto("/");
  const outline = (selector: string) =>
    page.locator(selector).evaluate((node) => getComputedStyle(node).outlineStyle);
  expect(await outline(".switch-choice.hamilton")).toBe("solid");
  expect(await outline(".switch-choice.jpl")).toBe("none");
  expect(await outline(".choice label:has([value=degrees])")).toBe("solid");
  expect(await outline(".choice label:has([value=radians])")).toBe("none");
  const edges = (node: Element) => getComputedStyle(node).borderStyle;
  expect(await page.locator(".picture").evaluate(edges)).toBe("solid");
  await page.goto("/#translate");
  // A bar differs from the track under it.
  const bar = page.locator(".mistake-bar").first();
  const colour = (node: Element) => getComputedStyle(node).backgroundColor;
  expect(await bar.locator("span").evaluate(colour)).not.toBe(await bar.evaluate(colour));
});

test("a print has the results and none of the tools", async ({ page }) => {
  await page.goto("/");
  await page.getByRole("button", { name: "Theme: as the system" }).click();
  await page.emulateMedia({ media: "print" });
  await expect(matrix(page, "R(q)")).toBeVisible();
  await expect(quaternionField(page)).toBeVisible();
  for (const hidden of [".views", ".tools", ".examples", ".number-settings"]) {
    await expect(page.locator(hidden)).toBeHidden();
  }
  expect(await paper(page)).toBe(light);
});
