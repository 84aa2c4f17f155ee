// The picture under a finger: on the body it turns it, beside it the page is moved.
import type { Page } from "@playwright/test";
import { test as base, bodyOn, expect, fromX, quaternionField } from "./support/page.ts";

interface Point {
  x: number;
  y: number;
}

type Finger = Record<"start" | "move", (...points: Point[]) => Promise<unknown>> & {
  end: () => Promise<unknown>;
};

/** A phone: a finger that is put down, moved and lifted. */
const test = base.extend<{ finger: Finger }>({
  finger: async ({ page }, use) => {
    const session = await page.context().newCDPSession(page);
    const send = (type: "touchStart" | "touchMove" | "touchEnd", ...touchPoints: Point[]) =>
      session.send("Input.dispatchTouchEvent", { type, touchPoints });
    await use({
      start: (...points) => send("touchStart", ...points),
      move: (...points) => send("touchMove", ...points),
      end: () => send("touchEnd"),
    });
  },
});
test.use({ hasTouch: true, viewport: { width: 390, height: 844 } });

const scrolled = (page: Page) => page.evaluate(() => scrollY);
const parts = [0.05, 0.2, 0.4, 0.6, 0.8, 1];

for (const [way, right, down, written] of [
  ["to the right", 1, 0, "90deg about z"],
  ["down", 0, 1, "90deg about y"],
] as const) {
  test(`a finger turns the body ${way}, and the page stays`, async ({ page, finger }) => {
    await page.goto(`/#read?quaternion=1+0+0+0&${fromX}`);
    const { x, y } = await bodyOn(page);
    const before = await scrolled(page);
    await finger.start({ x, y });
    // 150 pixels at 0.6° each.
    for (const part of parts) {
      const by = part * 150;
      await finger.move({ x: x + right * by, y: y + down * by });
    }
    await finger.end();
    await expect(quaternionField(page)).toHaveValue(written);
    expect(await scrolled(page)).toBe(before);
    await page.getByRole("button", { name: "Undo" }).click();
    await expect(quaternionField(page)).toHaveValue("1 0 0 0");
  });
}

test("a finger beside the body moves the page and nothing else", async ({ page, finger }) => {
  await page.goto(`/#read?quaternion=1+0+0+0&${fromX}`);
  const { box } = await bodyOn(page);
  const before = await scrolled(page);
  const [x, y] = [box.x + 10, box.y + 250];
  await finger.start({ x, y });
  for (const part of parts) await finger.move({ x: x + part * 20, y: y - part * 140 });
  await finger.end();
  await expect.poll(() => scrolled(page)).toBeGreaterThan(before + 50);
  await expect(quaternionField(page)).toHaveValue("1 0 0 0");
  await expect(page).toHaveURL(/look=0,0/);
});

test("a second finger takes back what the first one turned", async ({ page, finger }) => {
  await page.goto(`/#read?quaternion=1+0+0+0&${fromX}`);
  const { x, y } = await bodyOn(page);
  await finger.start({ x, y });
  for (const part of parts) await finger.move({ x: x + part * 60, y });
  await expect(quaternionField(page)).toHaveValue(/deg about /);
  await finger.start({ x: x + 60, y }, { x: x - 60, y });
  await expect(quaternionField(page)).toHaveValue("1 0 0 0");
  await finger.move({ x: x + 100, y }, { x: x - 100, y });
  await finger.end();
  await expect(quaternionField(page)).toHaveValue("1 0 0 0");
});
