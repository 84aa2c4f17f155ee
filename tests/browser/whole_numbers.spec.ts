// No number of any view is cut at any width, with any number of decimals. engines.spec.ts has the other
// engines.
import { expect, haveNoLetters, matrix, openEverything, test } from "./support/page.ts";
import { addresses, cutNumbers, isShown } from "./support/whole_numbers.ts";

const widths = [320, 390, 560, 768, 992, 1280, 1920];

for (const address of addresses) {
  test(`every number is whole: ${address}`, async ({ page }) => {
    await page.goto(`/#${encodeURI(address)}`);
    await page.waitForFunction(isShown);
    for (const width of widths) {
      await page.setViewportSize({ width, height: 800 });
      expect(await page.evaluate(cutNumbers), `${width} px`).toEqual([]);
    }
  });
}

test("every number is whole in the letters of the system", async ({ page }) => {
  await haveNoLetters(page);
  for (const address of ["read", "compose"]) {
    await page.goto(`/#${address}`);
    await page.waitForFunction(isShown);
    for (const width of widths) {
      await page.setViewportSize({ width, height: 800 });
      expect(await page.evaluate(cutNumbers), `${address}, ${width} px`).toEqual([]);
    }
  }
});

for (const width of [320, 390, 1280]) {
  test(`a number that is edited shows all its digits beside the others, ${width} px`, async ({
    page,
  }) => {
    await page.setViewportSize({ width, height: 800 });
    await page.goto("/#read?quaternion=-0.1234567890123 0.3 -0.4 0.86");
    await expect(matrix(page, "R(q)")).toBeVisible();
    await openEverything(page);
    const faults = await page.evaluate(async () => {
      const found: string[] = [];
      // Where there is room for one column, both, as if the visitor switched.
      document.querySelector(".columns")?.setAttribute("class", "columns");
      for (const field of document.querySelectorAll<HTMLInputElement>(".result .number")) {
        field.dispatchEvent(new MouseEvent("mousedown", { bubbles: true, cancelable: true }));
        await new Promise((painted) => requestAnimationFrame(painted));
        if (!field.matches(":focus.editing")) found.push(`${field.ariaLabel} is not edited`);
        const isCut = field.scrollWidth > field.clientWidth;
        const beyond = document.documentElement.scrollWidth - innerWidth;
        if (isCut || beyond > 0) found.push(`${field.ariaLabel} ${isCut} ${beyond}`);
      }
      return found;
    });
    expect(faults).toEqual([]);
  });
}

test("a matrix that goes on says on which side", async ({ page }) => {
  await page.setViewportSize({ width: 320, height: 800 });
  await page.goto("/#read?digits=all&quaternion=0.1 0.2 0.3 0.4");
  const frame = page.locator(".side-scroll").first();
  const scrollTo = (left: number) =>
    frame.locator("section").evaluate((node, left) => node.scrollTo({ left }), left);
  await expect(frame).toHaveAttribute("data-hidden", "right");
  await scrollTo(60);
  await expect(frame).toHaveAttribute("data-hidden", "left right");
  await scrollTo(10_000);
  await expect(frame).toHaveAttribute("data-hidden", "left");
  await page.setViewportSize({ width: 1280, height: 800 });
  await expect(frame).toHaveAttribute("data-hidden", "");
});

test("no matrix goes on beyond its place on paper, on a tablet and on a phone", async ({
  page,
}) => {
  await page.goto("/#read?quaternion=-0.1111111111111119 -0.2 0.38 -0.92");
  await expect(matrix(page, "R(q)")).toBeVisible();
  for (const [width, media] of [
    [718, "print"],
    [704, "screen"],
    [768, "screen"],
    [390, "screen"],
    [360, "screen"],
  ] as const) {
    await page.setViewportSize({ width, height: 1000 });
    await page.emulateMedia({ media });
    const wide = await page
      .locator(".matrix-scroll:visible")
      .evaluateAll((found) =>
        found
          .filter(({ scrollWidth, clientWidth }) => scrollWidth > clientWidth)
          .map((frame) => `${frame.ariaLabel} at ${innerWidth} px`),
      );
    expect(wide, media).toEqual([]);
  }
});

for (const deviceScaleFactor of [1, 1.5, 2, 3]) {
  test.describe(() => {
    test.use({ deviceScaleFactor });
    test(`nothing is drawn round a matrix that has room, ${deviceScaleFactor} pixels each`, async ({
      page,
    }) => {
      await page.goto("/");
      await expect(matrix(page, "R(q)")).toBeVisible();
      const frames = page.locator(".matrix-scroll");
      await frames.locator("table").evaluateAll((tables: HTMLElement[]) => {
        for (const table of tables) table.style.visibility = "hidden";
      });
      for (const frame of await frames.filter({ visible: true }).all()) {
        const image = (await frame.screenshot()).toString("base64");
        expect(await page.evaluate(coloursOf, image)).toHaveLength(1);
      }
    });
  });
}

/** The colours of an image. To be run in the page. */
async function coloursOf(base64: string): Promise<number[]> {
  const image = new Image();
  image.src = `data:image/png;base64,${base64}`;
  await image.decode();
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [image.width, image.height];
  const pen = canvas.getContext("2d");
  pen?.drawImage(image, 0, 0);
  const pixels = pen?.getImageData(0, 0, image.width, image.height).data.buffer;
  return [...new Set(new Uint32Array(pixels ?? new ArrayBuffer(0)))];
}
