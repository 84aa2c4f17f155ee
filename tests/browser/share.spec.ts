// Sharing: the link, as Markdown and as a citation; the version in the address and on the page.
import { readFileSync } from "node:fs";
import type { Page } from "@playwright/test";
import { expect, quaternionField, sidewaysScroll, test, violationsIn } from "./support/page.ts";

test.beforeEach(({ context }) => context.grantPermissions(["clipboard-read", "clipboard-write"]));

const { version } = JSON.parse(
  readFileSync(new URL("../../package.json", import.meta.url), "utf8"),
);

const clipboard = (page: Page) => page.evaluate(() => navigator.clipboard.readText());

async function shared(page: Page, what: string): Promise<string> {
  const panel = page.getByRole("dialog", { name: "Share what the page shows" });
  if (!(await panel.isVisible())) await page.getByRole("button", { name: "Share" }).click();
  await panel.getByRole("button", { name: `Copy: ${what}`, exact: true }).click();
  await expect(page.getByText(`${what}: copied`, { exact: true })).toBeVisible();
  return clipboard(page);
}

test("a case of Read is cited in a sentence with its link", async ({ page, baseURL }) => {
  await page.goto("/");
  expect(await shared(page, "Cite this case")).toBe(
    `Unit quaternion (0.92388, 0, 0, 0.38268), Hamilton (w x y z, body to world): 45° about z. quatlas ${version}, ${baseURL}#read?v=1`,
  );
  expect(await shared(page, "Link")).toBe(`${baseURL}#read?v=1`);
  expect(await shared(page, "Link as Markdown")).toBe(
    `[45° about z · Hamilton 0.9239 0 0 0.3827 · quatlas](${baseURL}#read?v=1)`,
  );
});

test("the numbers, the norm and the convention of a citation are those that were declared", async ({
  page,
  baseURL,
}) => {
  await page.goto("/#read?as=jpl&function=active&quaternion=0+0+-3+4");
  expect(await shared(page, "Cite this case")).toBe(
    `Quaternion (0, 0, -3, 4) of norm 5, JPL (x y z w, active, world to body): 73.74° about z. quatlas ${version}, ${baseURL}#read?v=1&quaternion=0+0+-3+4&as=jpl&function=active`,
  );
});

test("a product and a translation are cited too", async ({ page }) => {
  await page.goto("/#compose?p=i&q=j");
  expect(await shared(page, "Cite this case")).toMatch(
    /^\(0, 1, 0, 0\) ⊙ \(0, 0, 1, 0\) = \(0, 0, 0, 1\), Hamilton \(w x y z, body to world\): the right one acts first\. quatlas/,
  );
  await page.goto("/#translate?translated=0+0+0.6+0.8&from=openvins&to=drake");
  expect(await shared(page, "Cite this case")).toMatch(
    /^Unit quaternion \(0, 0, 0\.6, 0\.8\) of OpenVINS is \(0\.8, 0, 0, 0\.6\) in Drake: 73\.74° about z\. quatlas/,
  );
});

test("Markdown is not broken by what was typed", async ({ page }) => {
  await page.goto("/#identify?name=%5B1,+0,+0%5D%0A%281%29");
  const markdown = await shared(page, "Link as Markdown");
  expect(markdown).toMatch(/^\[\\\[1, 0, 0\\\] \(1\) · Identify · quatlas\]\(http[^()\s]*\)$/);
});

test("a text with a problem is not cited, and other views share their link", async ({ page }) => {
  await page.goto("/#read?quaternion=oops");
  await page.getByRole("button", { name: "Share" }).click();
  await expect(page.getByText("There is nothing to cite while the text has")).toBeVisible();
  await expect(page.getByRole("button", { name: "Copy: Cite this case" })).toHaveCount(0);
  await page.keyboard.press("Escape");
  await page.goto("/#libraries?library=openvins");
  // The record is scrolled to when it comes, which closes what is open.
  await expect(page.locator("table").first()).toBeVisible();
  await expect(page.getByRole("article", { name: /OpenVINS/ })).toBeInViewport();
  expect(await shared(page, "Link")).toMatch(/#libraries\?v=1&library=openvins$/);
  await expect(page.getByRole("button", { name: "Copy: Cite this case" })).toHaveCount(0);
});

test("the panel is used by keyboard, fits a phone and has nothing for axe", async ({ page }) => {
  await page.setViewportSize({ width: 320, height: 640 });
  await page.goto("/");
  const button = page.getByRole("button", { name: "Share" });
  await button.focus();
  await page.keyboard.press("Enter");
  await expect(page.getByRole("button", { name: "Copy: Link", exact: true })).toBeFocused();
  await page.keyboard.press("Tab");
  await expect(page.getByRole("button", { name: "Copy: Link as Markdown" })).toBeFocused();
  const box = await page.getByRole("dialog").boundingBox();
  expect(box?.x).toBeGreaterThanOrEqual(0);
  expect((box?.x ?? 0) + (box?.width ?? 0)).toBeLessThanOrEqual(320);
  expect(await sidewaysScroll(page)).toBeLessThanOrEqual(0);
  await page.keyboard.press("Escape");
  await expect(button).toBeFocused();
  await page.keyboard.press("Enter");
  await expect(page.getByRole("dialog")).toBeVisible();
  expect(await violationsIn(page, ".popup")).toEqual([]);
});

test("an address of a newer version opens what is known, says so and is kept", async ({ page }) => {
  await page.goto("/#read?v=2&quaternion=1+0+0+1&picture=left");
  const line = page.getByText("This link was made by a newer quatlas");
  await expect(line).toBeVisible();
  await expect(page.getByRole("textbox", { name: "quaternion q" })).toHaveValue("1 0 0 1");
  await page.getByRole("button", { name: "Copy Hamilton q", exact: true }).click();
  await expect(page).toHaveURL(/v=2.*picture=left/);
  await page.getByRole("textbox", { name: "quaternion q" }).fill("0 1 0 0");
  await expect(page).toHaveURL(/#read\?v=1&quaternion=0\+1\+0\+0$/);
  await page.goto("/#read?v=1&quaternion=1+0+0+1");
  await expect(line).toHaveCount(0);
});

test("the page says which version it is", async ({ page }) => {
  await page.goto("/");
  await expect(page.getByRole("contentinfo")).toContainText(`quatlas ${version}`);
});

test("of a long text the address holds the numbers that were read, and a reload the text", async ({
  page,
}) => {
  const poses = Array.from({ length: 400 }, (_, at) => `[INFO] [${at}.5]: waiting for a transform`);
  const text = [...poses, "world_to_body: orientation: {x: 0.1, y: 0.3, z: 0.5, w: 0.8}"].join(
    "\n",
  );
  await page.goto("/");
  await quaternionField(page).fill(text);
  const said = page.getByText("The text is too long for an address");
  await expect(said).toBeVisible();
  await page.keyboard.press("Escape");
  const short = new URLSearchParams(await shared(page, "Link").then((link) => link.split("?")[1]));
  expect(short.get("quaternion")).toBe("w=0.8 x=0.1 y=0.3 z=0.5");
  expect(short.get("direction")).toBe("world-to-body");
  await expect(page).toHaveURL(/quaternion=w%3D0\.8\+x%3D0\.1/);
  await page.reload();
  await expect(quaternionField(page)).toHaveValue(text);
  await expect(said).toBeVisible();
});

test("a long text stays in the address where its numbers alone would be another rotation", async ({
  page,
}) => {
  const lines = "[INFO]: waiting for a transform\n".repeat(300);
  const numbers = "orientation: {x: 0.1, y: 0.3, z: 0.5, w: 0.8}";
  const quaternionOfLink = async (text: string) => {
    await page.goto("/#translate?from=eigen&to=drake");
    await page.getByRole("textbox", { name: "quaternion" }).first().fill(text);
    await expect(page.getByText("The text is too long for an address")).toHaveCount(
      text.includes("world_to_body") ? 0 : 1,
    );
    await page.keyboard.press("Escape");
    const link = await shared(page, "Link");
    return new URLSearchParams(link.split("?")[1]).get("translated");
  };
  expect(await quaternionOfLink(`${lines}${numbers}`)).toBe("w=0.8 x=0.1 y=0.3 z=0.5");
  const directed = `${lines}world_to_body: ${numbers}`;
  expect(await quaternionOfLink(directed)).toBe(directed);
});
