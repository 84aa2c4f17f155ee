// A print ends with what it is a print of, and that never stands on a page alone.
import { expect, test } from "./support/page.ts";
import { piecesPrinted } from "./support/printed.ts";

test("a print ends with the case and its address, and never on a page with these alone", async ({
  page,
  baseURL,
}) => {
  test.slow();
  const cases = [
    ["read?v=1&quaternion=0+0+0.6+0.8&as=jpl", "73.74° about z · JPL 0 0 0.6 0.8 · quatlas"],
    ["compose?v=1&p=i&q=j", "p ⊙ q = 0 0 0 1 · Hamilton · quatlas"],
  ];
  await page.goto("./");
  for (const [fragment = "", title = ""] of cases) {
    await page.goto(`./#${fragment}`);
    await expect(page).toHaveTitle(title);
    await expect(page.locator(".picture svg, .steps svg").first()).toBeVisible();
    await page.emulateMedia({ media: "print" });
    const footer = page.getByRole("contentinfo");
    await expect(footer.getByRole("link")).toHaveText([title]);
    await expect(footer.getByText(`${baseURL}#${fragment}`)).toBeVisible();

    await page.locator("main, .masthead").evaluateAll(hide);
    const [alone = 0, ...others] = await piecesPrinted(page, 0);
    expect(others).toEqual([]);
    await page.locator("main, .masthead").evaluateAll(show);
    // Wherever the last sheet ends.
    let sheets = 0;
    for (const bottomMarginPx of [0, 40, 80, 120, 400]) {
      const pieces = await piecesPrinted(page, bottomMarginPx);
      sheets = pieces.length;
      expect(pieces.at(-1), `${fragment}, ${bottomMarginPx} px`).toBeGreaterThan(alone);
    }
    expect(sheets).toBeGreaterThan(1);
    await page.emulateMedia({ media: null });
  }
});

const hide = (elements: (HTMLElement | SVGElement)[]) => {
  for (const { style } of elements) style.display = "none";
};

const show = (elements: (HTMLElement | SVGElement)[]) => {
  for (const { style } of elements) style.display = "";
};
