// What those meet who do not see the page, or enlarge it: its tree of names and roles, what is said
// aloud and how often, and whether everything fits.
import type { Page } from "@playwright/test";
import { views } from "../../www/model/page_state.ts";
import { expect, openEverything, quaternionField, sidewaysScroll, test } from "./support/page.ts";

async function open(page: Page, address: string) {
  await page.goto(`/#${address}`);
  // The page that is readable without script has neither.
  await expect(page.locator(".views [aria-current=page]")).toBeVisible();
  await expect(page.locator("main .loading")).toHaveCount(0);
}

test("the tree of the Read view has a name and a role for everything", async ({ page }) => {
  await open(page, "read");
  await expect(page.getByRole("application")).toBeVisible();
  await expect(page.locator("body")).toMatchAriaSnapshot(`
    - button "Go to the result"
    - banner:
      - heading "quatlas" [level=1]
      - navigation "Views":
        - link "Read"
        - link "Compose"
        - link "Motion"
        - link "Frames"
        - link "Libraries"
      - button "Share"
    - main:
      - region "Input":
        - textbox "quaternion q": cos(pi/8) + sin(pi/8) k
        - button "Undo" [disabled]
        - button "Redo" [disabled]
        - group "The text is meant as":
          - radio /Hamilton/ [checked]
          - radio /JPL/
        - textbox "vector v"
        - radiogroup "Angles"
        - radiogroup "Decimals"
        - list "Examples"
        - button "More examples"
        - paragraph:
          - 'link "Translate this: q"'
          - 'link "Compose with this: q"'
      - region "Hamilton":
        - heading "Hamilton" [level=2]
        - definition:
          - textbox "Hamilton q, w": "0.923880"
        - button "Copy Hamilton q"
        - figure:
          - region "R(q), row by row":
            - grid "R(q)":
              - rowgroup:
                - row "0.707107 −0.707107 0":
                  - gridcell "0.707107":
                    - textbox "R(q), row 1, column 1": "0.707107"
          - button "Copy R(q)"
      - region "JPL":
        - heading "JPL" [level=2]
        - definition:
          - textbox "JPL q, x": "0"
      - region "Picture":
        - group "What moves":
          - radio /Passive/ [checked]
          - radio /Active/
        - application "Picture of the rotation"
        - checkbox "Also as JPL body → world"
        - button "First view"
        - button "Save SVG"
      - region "How the two readings relate"
      - region "The rotation, the same in every convention":
        - heading "Axis and angle" [level=2]
        - heading "Rotation vector" [level=2]
        - heading "Euler angles" [level=2]
        - combobox "Euler axes"
        - definition:
          - textbox "yaw in degrees": "45"
        - heading "The other sign" [level=2]
      - region "More about this rotation":
        - group: What each convention multiplies, the product matrices, and the matrix as chosen beside q
    - contentinfo
    - status: /Result. a rotation by 45° about z/
  `);
});

for (const view of views) {
  test(`everything that can be used in ${view} has a name`, async ({ page }) => {
    await open(page, view);
    await openEverything(page);
    const nameless = await page.evaluate(() => {
      const named = (element: Element) =>
        element.getAttribute("aria-label")?.trim() ||
        element.getAttribute("aria-labelledby") ||
        (element as HTMLInputElement).labels?.[0]?.textContent?.trim() ||
        (element.matches("button, a, summary") && element.textContent?.trim()) ||
        element.querySelector("title");
      const usable =
        "a[href], button, input, select, textarea, summary, [tabindex='0'], [role=application]";
      return [...document.querySelectorAll(usable)]
        .filter((element) => !named(element))
        .map((element) => element.outerHTML.slice(0, 120));
    });
    expect(nameless).toEqual([]);
  });
}

/** Counts what the live region says from now on. */
async function listen(page: Page) {
  await page.evaluate(() => {
    const said: string[] = [];
    Object.assign(globalThis, { said });
    const region = document.querySelector("[role=status]");
    new MutationObserver(() => said.push(region?.textContent ?? "")).observe(region as Element, {
      characterData: true,
      childList: true,
      subtree: true,
    });
  });
  return () => page.evaluate(() => (globalThis as unknown as { said: string[] }).said);
}

test("a result is said once, when the typing rests", async ({ page }) => {
  await page.clock.install();
  await open(page, "read");
  const said = await listen(page);
  await quaternionField(page).focus();
  await page.keyboard.press("ControlOrMeta+a");
  await page.clock.pauseAt(new Date(Date.now() + 60_000));
  // A tenth of a second between the keys, on the page's own clock.
  for (const character of "90deg about [1, 0, 0]") {
    await page.keyboard.type(character);
    await page.clock.runFor(100);
  }
  expect(await said()).toEqual([]);
  await page.clock.runFor(1000);
  expect(await said()).toEqual([expect.stringMatching(/a rotation by 90.* about x/)]);
});

test("what was done is said by the one live region, beside the result", async ({ page }) => {
  await open(page, "read");
  await expect(page.locator("[aria-live], [role=status], [role=log]")).toHaveCount(1);
  const region = page.getByRole("status");
  // Only what changes is read out.
  await expect(region).toHaveAttribute("aria-atomic", "false");
  const done = region.locator("[data-said=done]");
  const shown = region.locator(".said");
  await page.keyboard.press("u");
  await expect(done).toHaveText("Angles: radians");
  await expect(shown).toHaveCount(0);
  await page.getByRole("button", { name: "Copy Hamilton q" }).first().click();
  await expect(done).toHaveText("Hamilton q copied");
  // Nothing else on the page shows it.
  await expect(shown).toHaveText("Hamilton q copied");
  // The same words again are another text, or they would not be read out.
  const before = await done.textContent();
  await page.getByRole("button", { name: "Copy Hamilton q" }).first().click();
  await expect.poll(() => done.textContent()).not.toBe(before);
  await expect(done).toHaveText("Hamilton q copied");
  await expect(shown).toHaveCount(0);
  await page.keyboard.press("u");
  await expect(done).toHaveText("Angles: degrees");
  await quaternionField(page).fill("0 0 0 1");
  await expect(done).toHaveText("");
  await expect(region).toHaveText(/a rotation by/);
});

test("turning the body is said once, when it rests", async ({ page }) => {
  await open(page, "read?quaternion=1+0+0+0&look=0,0");
  const said = await listen(page);
  await page.getByRole("application").focus();
  for (let presses = 0; presses < 6; presses += 1) await page.keyboard.press("Shift+ArrowRight");
  await expect(page.getByRole("status")).toHaveText("Result: a rotation by 30° about z.");
  expect((await said()).length).toBeLessThanOrEqual(2);
});

for (const view of views) {
  test(`${view} fits 320 px, and 1280 px at 200 %, with all digits and everything open`, async ({
    page,
  }) => {
    for (const width of [320, 640]) {
      await page.setViewportSize({ width, height: 800 });
      for (const address of [view, `${view}?digits=all&unit=rad`]) {
        await open(page, address);
        await openEverything(page);
        expect(await sidewaysScroll(page), `${address} at ${width} px`).toBeLessThanOrEqual(0);
      }
    }
  });
}

test("the first stop of the Tab key leads past the fields to the result", async ({ page }) => {
  await open(page, "read");
  await page.keyboard.press("Tab");
  await expect(page.getByRole("button", { name: "Go to the result" })).toBeFocused();
  await page.keyboard.press("Enter");
  await page.keyboard.press("Tab");
  await expect(page.getByRole("textbox", { name: "Hamilton q, w" })).toBeFocused();
});

test("the title tells the case, and where there is none the view", async ({ page }) => {
  const titles = [
    ["read", "45° about z · Hamilton 0.9239 0 0 0.3827"],
    [
      "read?as=jpl&quaternion=0.02 -0.01 0.38 0.92",
      "44.96° about (0.0525, −0.0263, 0.998) · JPL 0.02 −0.01 0.38 0.92",
    ],
    ["read?order=scalar-last&quaternion=0 0 0 1", "no rotation · Hamilton (x y z w) 0 0 0 1"],
    [
      "read?handedness=left&quaternion=0.6 0 0 0.8",
      "106.3° about −z · custom (w x y z) 0.6 0 0 0.8",
    ],
    ["read?quaternion=1 2 3", "Read"],
    ["compose?p=0.6 0 0 0.8&q=i", "p ⊙ q = 0 0.6 0.8 0 · Hamilton"],
    [
      "translate?translated=0.1 -0.2 0.4 0.888819441731559&from=openvins&to=:hamilton",
      "OpenVINS → Hamilton · 0.8888 0.1 −0.2 0.4",
    ],
    ["motion", "Hamilton 0.9239 0 0 0.3827 · ω 0.3 −0.2 0.5 rad/s"],
    ["motion?rate=", "Motion"],
    ["identify?name=My library", "My library · Identify"],
    ["libraries?library=openvins", "OpenVINS · All libraries"],
    ["libraries", "All libraries"],
  ];
  for (const [address = "", title] of titles) {
    await open(page, address);
    await expect(page).toHaveTitle(`${title} · quatlas`);
  }
  // It follows the text.
  await open(page, "read");
  await page.getByRole("textbox", { name: "quaternion q" }).fill("90deg about x");
  await expect(page).toHaveTitle(/^90° about x · Hamilton 0\.7071 0\.7071 0 0 · quatlas$/);
});
