// The card of the picture: what it shows has room, and its height is that of its place.
import { asText, randomAttitude, randomFrom } from "./support/attitudes.ts";
import { expect, fromX, press, quaternionField, stage, test } from "./support/page.ts";

test("no label is drawn on another one, or beyond the paper", async ({ page }) => {
  const random = randomFrom(5);
  const found: string[] = [];
  for (const shown of ["", "&picture=active", "&poses=both"]) {
    await page.goto("about:blank");
    await page.goto(`/#read?vector=1+1+0${shown}`);
    await stage(page).locator("text").first().waitFor();
    await page.evaluate(() => document.fonts.ready);
    const attitudes = Array.from({ length: 7 }, () => asText(randomAttitude(random)));
    for (const text of ["cos(pi/8) + sin(pi/8) k", ...attitudes]) {
      await quaternionField(page).fill(text);
      await expect(page.locator(".picture-old")).toHaveCount(0);
      const wrong = await stage(page).evaluate(collidingLabels);
      found.push(...wrong.map((what) => `${what}: ${text} ${shown}`));
    }
  }
  expect(found).toEqual([]);
});

/** The labels whose boxes, as they are drawn, meet or are cut. */
function collidingLabels(drawn: Element): string[] {
  const paper = drawn.getBoundingClientRect();
  const boxes = [...drawn.querySelectorAll("text")].map((text) => ({
    name: text.textContent,
    box: text.getBoundingClientRect(),
  }));
  return boxes.flatMap(({ name, box }, at) => {
    const isCut =
      box.left < paper.left ||
      box.right > paper.right ||
      box.top < paper.top ||
      box.bottom > paper.bottom;
    const under = boxes
      .slice(at + 1)
      .filter(
        ({ box: other }) =>
          box.left < other.right &&
          other.left < box.right &&
          box.top < other.bottom &&
          other.top < box.bottom,
      );
    return [
      ...(isCut ? [`${name} is cut`] : []),
      ...under.map((other) => `${name} and ${other.name}`),
    ];
  });
}

test("the drawing fills its card, whose height nothing changes", async ({ page }) => {
  await page.goto(`/#read?quaternion=1+0+0+0&${fromX}`);
  await stage(page).waitFor();
  const heights = async () => {
    const boxes = [page.locator(".picture"), stage(page), stage(page).locator("svg")];
    return Promise.all(boxes.map(async (box) => (await box.boundingBox())?.height));
  };
  const [card, place, drawing] = await heights();
  expect(card).toBeGreaterThanOrEqual(380);
  // Less than half of the least card is words.
  expect(place).toBeGreaterThan(230);
  expect(drawing).toBe(place);
  const viewBox = () => stage(page).locator("svg").getAttribute("viewBox");
  const { width } = (await stage(page).boundingBox()) ?? { width: 0 };
  await expect.poll(viewBox).toBe(`0 0 ${Math.round(width)} ${Math.round(place ?? 0)}`);
  await stage(page).focus();
  await press(page, "Shift+ArrowDown", 3);
  await press(page, "Shift+ArrowRight", 2);
  await page.getByRole("checkbox", { name: /^Also as/ }).check();
  expect(await heights()).toEqual([card, place, drawing]);
  await page.getByRole("radio", { name: "Active" }).check();
  expect(await heights()).toEqual([card, place, drawing]);
});

test("the first view is gone back to", async ({ page }) => {
  await page.goto("/#read?look=30,22");
  await stage(page).focus();
  await page.keyboard.press("ArrowLeft");
  await expect(page).toHaveURL(/look=35,22/);
  await page.getByRole("button", { name: "First view" }).click();
  await expect(page).not.toHaveURL(/look=/);
});

test("where colours are forced, the card has its edges and the body its sides", async ({
  page,
}) => {
  for (const view of ["read", "compose"]) {
    await page.emulateMedia({ forcedColors: "active" });
    await page.goto(`/#${view}`);
    await page.locator(".stage text").first().waitFor();
    const edges = await page.locator(".picture").evaluate((card) => {
      const style = getComputedStyle(card);
      const sides = ["Top", "Right", "Bottom", "Left"] as const;
      return sides.map((side) =>
        [`border${side}Style`, `border${side}Width`, `border${side}Color`]
          .map((name) => style[name as "borderTopStyle"])
          .join(" "),
      );
    });
    expect(new Set(edges).size).toBe(1);
    expect(edges[0]).toMatch(/^solid 1px /);
    expect(edges[0]).not.toBe(
      await page.locator(".picture").evaluate((card) => {
        return `solid 1px ${getComputedStyle(card).backgroundColor}`;
      }),
    );
    // Nothing but the colours of the system: no shade of a colour that was not asked for.
    const fills = await page
      .locator(".picture-body path")
      .evaluateAll((paths) => [...new Set(paths.map((path) => getComputedStyle(path).fill))]);
    const canvas = await page
      .locator("body")
      .evaluate((body) => getComputedStyle(body).backgroundColor);
    expect(fills.filter((fill) => fill !== "none")).toEqual([canvas]);
  }
});
