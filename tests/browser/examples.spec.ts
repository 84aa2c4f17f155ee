// Every example of the gallery gives a result, and shows what its line promises.
import type { Page } from "@playwright/test";
import { fromFragment, toFragment } from "../../www/address/fragment.ts";
import { stateOf } from "../../www/model/examples/example.ts";
import { featured } from "../../www/model/examples/featured.ts";
import {
  type ExampleName,
  exampleNames,
  exampleOf,
  gallery,
} from "../../www/model/examples/gallery.ts";
import { randomAttitude } from "../../www/model/examples/random_attitude.ts";
import { opening } from "../../www/model/page_state.ts";
import { featuredNames, moreExamples } from "../../www/words/examples/featured.ts";
import { exampleWords } from "../../www/words/examples/gallery.ts";
import { expect, matrix, numbersOf, quaternionField, test } from "./support/page.ts";

const notes = (page: Page) => page.locator(".notes");
const facts = (page: Page) => page.locator(".facts");
const said = (page: Page) => page.getByRole("status");
const array = (page: Page, symbol: string) =>
  page.locator(".row", { has: page.getByRole("button", { name: `Copy ${symbol}`, exact: true }) });

async function isTransposed(page: Page) {
  const c = await numbersOf(matrix(page, "C(q)"));
  const r = await numbersOf(matrix(page, "R(q)"));
  expect(r).toEqual([0, 3, 6, 1, 4, 7, 2, 5, 8].map((at) => c[at]));
}

const quarter = Math.SQRT1_2;
const rounded = (number: number) => Number(number.toFixed(6));
const turnAboutZ = [quarter, -quarter, 0, quarter, quarter, 0, 0, 0, 1].map(rounded);

/** What each example teaches, as it stands on the page. */
const promises: Record<ExampleName, (page: Page) => Promise<void>> = {
  "turn-about-z": async (page) => {
    expect(await numbersOf(matrix(page, "R(q)"))).toEqual(turnAboutZ);
    await isTransposed(page);
  },
  "jpl-log": async (page) => {
    await expect(page.getByRole("region", { name: "JPL" }).getByText("as declared")).toBeVisible();
    // C(q) by hand, of the numbers as x y z w.
    expect(await numbersOf(matrix(page, "C(q)"))).toEqual([
      0.010833, -0.008778, -0.999903, -0.050847, 0.998663, -0.009318, 0.998648, 0.050943, 0.010373,
    ]);
    await expect(page.getByText("nothing is conjugated")).toBeVisible();
  },
  "ros-message": async (page) => {
    // Equal z and w: a quarter turn about z.
    expect(await numbersOf(matrix(page, "R(q)"))).toEqual([0, -1, 0, 1, 0, 0, 0, 0, 1]);
  },
  "yaw-pitch-roll": async (page) => {
    await expect(page.locator(".read-as")).toContainText("Euler angles ZYX, about the moving axes");
    // Rz(30) Ry(20) Rx(10), first column: cos 20 cos 30, cos 20 sin 30, −sin 20.
    const r = await numbersOf(matrix(page, "R(q)"));
    expect([r[0], r[3], r[6]]).toEqual([0.813798, 0.469846, -0.34202]);
  },
  matrix: async (page) => {
    expect(await numbersOf(matrix(page, "R(q)"))).toEqual([
      0.36, -0.48, 0.8, 0.8, 0.6, 0, -0.48, 0.64, 0.6,
    ]);
  },
  "axis-and-angle": async (page) => {
    await expect(said(page)).toHaveText(/a rotation by 90° about \[0, 0\.707107, 0\.707107\]/);
  },
  "third-of-a-turn": async (page) => {
    await expect(said(page)).toContainText("a rotation by 120° about");
    // (1, 2, 3) on the body axes: x becomes y, y becomes z, z becomes x.
    await expect(array(page, "R(q) v")).toContainText("[3, 1, 2]");
  },
  "transposed-matrix": async (page) => {
    expect(await numbersOf(matrix(page, "C(q)"))).toEqual([0.8, 0.6, 0, -0.6, 0.8, 0, 0, 0, 1]);
    await isTransposed(page);
  },
  "double-cover": async (page) => {
    await expect(notes(page)).toContainText("−q is the same rotation");
    expect(await numbersOf(matrix(page, "R(q)"))).toEqual(turnAboutZ);
  },
  "gimbal-lock": async (page) => {
    await expect(facts(page)).toContainText("Gimbal lock");
    await expect(facts(page)).toContainText("yaw − roll = 20° is determined");
  },
  "half-turn": async (page) => {
    await expect(page.locator(".note-beside")).toContainText("the matrix is its own transpose");
    expect(await numbersOf(matrix(page, "R(q)"))).toEqual(await numbersOf(matrix(page, "C(q)")));
  },
  "invisible-order": async (page) => {
    await expect(notes(page)).toContainText("cannot show its order");
  },
  "norm-of-two": async (page) => {
    await expect(notes(page)).toContainText("The norm is 2");
    await expect(page.getByText("the inverse: conjugate / norm²").first()).toBeVisible();
  },
  "jpl-body-to-world": async (page) => {
    await expect(page.getByText("This is what you declared.")).toBeVisible();
    // C of (0, 0, 0.6, 0.8) is the matrix from body to world: the turn is about −z.
    expect(await numbersOf(matrix(page, "R(q)"))).toEqual([0.28, 0.96, 0, -0.96, 0.28, 0, 0, 0, 1]);
  },
  "both-orders": async (page) => {
    const strip = (name: string) => page.getByRole("region", { name }).locator(".strip dd");
    const hamilton = await strip("Hamilton: p ⊙ q").allTextContents();
    const jpl = await strip("JPL: q ⊗ p").allTextContents();
    expect([...jpl.slice(3), ...jpl.slice(0, 3)]).toEqual(hamilton);
    expect(await strip("Hamilton: q ⊙ p").allTextContents()).not.toEqual(hamilton);
  },
  commuting: async (page) => {
    await expect(page.getByText("These two commute")).toBeVisible();
  },
  "isaac-lab": async (page) => {
    await expect(page.getByRole("heading", { name: "Reordered, not conjugated" })).toBeVisible();
    await expect(page.locator(".translation-end + .translation-end dd")).toHaveText([
      "0",
      "0",
      "0.707107",
      "0.707107",
    ]);
  },
  "msckf-log": async (page) => {
    await expect(
      page.getByRole("heading", { name: "Neither reordered nor conjugated" }),
    ).toBeVisible();
  },
  "px4-to-ros": async (page) => {
    // Heading east in north-east-down is no turn in east-north-up.
    await expect(page.getByRole("heading", { name: /^Reordered.*other axes/ })).toBeVisible();
    await expect(page.locator(".translation-end + .translation-end dd")).toHaveText([
      "0",
      "0",
      "0",
      "1",
    ]);
  },
  "my-lab": async (page) => {
    await expect(page.getByRole("heading", { name: "“My Lab” of the field guide" })).toBeVisible();
    // Golden case G32, R_W^B.
    await page.getByText("and the matrix as chosen beside q").click();
    const paired = await numbersOf(matrix(page, "matrix as chosen beside q"));
    expect(paired.slice(0, 3)).toEqual([0.273847, 0.669743, 0.690255]);
  },
  random: async (page) => {
    // Of norm 1 and with w ≥ 0, so nothing has to be said of it.
    await expect(page.locator(".read-as")).toContainText("norm 1");
    await expect(notes(page)).toHaveCount(0);
  },
  "unknown-library": async (page) => {
    await expect(page.locator("main")).toContainText("ij = −k");
  },
  "unknown-angles": async (page) => {
    await expect(page.locator("main")).toContainText("Euler angles YXZ about the moving axes");
  },
};

for (const name of exampleNames) {
  const [words, teaches] = exampleWords[name];
  test(`the example ${words}: ${teaches}`, async ({ page }) => {
    await page.goto(`/#${toFragment(stateOf(exampleOf(name), opening))}`);
    await expect(page.locator(".result").first()).toHaveClass(/current/);
    await expect(page.locator(".problem")).toHaveCount(0);
    await promises[name](page);
  });
}

test("an example keeps the settings and what is typed in other views", () => {
  const state = {
    ...fromFragment("#read?digits=all&unit=rad&p=i&as=jpl&handedness=right&euler=xyz"),
    vector: "9 9 9",
  };
  expect(stateOf(gallery["half-turn"], state)).toEqual({
    ...opening,
    digits: "all",
    unit: "radians",
    p: "i",
    quaternion: "180° about [1, 1, 0]",
    vector: "1 0 0",
  });
});

test("the names and the lines of the gallery differ", () => {
  const words = Object.values(exampleWords);
  expect(new Set(words.map(([name]) => name)).size).toBe(exampleNames.length);
  expect(new Set(words.map(([, teaches]) => teaches)).size).toBe(exampleNames.length);
  expect(Object.keys(featuredNames)).toEqual(Object.keys(featured));
});

test("the gallery is opened, chosen from and left by keyboard, and going back returns", async ({
  page,
}) => {
  await page.goto("/");
  await quaternionField(page).fill("4 3 2 1");
  const more = page.getByRole("button", { name: moreExamples });
  await more.focus();
  await page.keyboard.press("Enter");
  const dialog = page.getByRole("dialog", { name: "Examples" });
  await expect(dialog.getByRole("link")).toHaveCount(exampleNames.length);
  await page.keyboard.press("Escape");
  await expect(dialog).toBeHidden();
  await expect(more).toBeFocused();

  await page.keyboard.press("e");
  await dialog.getByRole("link", { name: "Isaac Lab 2 to 3" }).press("Enter");
  await expect(dialog).toBeHidden();
  await expect(page.getByRole("heading", { name: "Reordered, not conjugated" })).toBeVisible();
  await page.goBack();
  await expect(quaternionField(page)).toHaveValue("4 3 2 1");
});

/** Uniform from 0 to 1, the same every time (mulberry32). */
function seeded(seed: number): () => number {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let mixed = Math.imul(state ^ (state >>> 15), state | 1);
    mixed ^= mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61);
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 4294967296;
  };
}

test("random attitudes are uniform over all attitudes, and unit quaternions as text", () => {
  const random = seeded(11);
  const count = 20_000;
  let [worstNorm, leastScalar] = [0, 1];
  const sums = { within90: 0, within45: 0, xx: 0, zz: 0, xy: 0, aboveTheEquator: 0 };
  for (let drawn = 0; drawn < count; drawn += 1) {
    const text = randomAttitude(random);
    const parts = /^w: (\S+), x: (\S+), y: (\S+), z: (\S+)$/.exec(text)?.slice(1).map(Number);
    const [w = Number.NaN, x = 0, y = 0, z = 0] = parts ?? [];
    worstNorm = Math.max(worstNorm, Math.abs(w * w + x * x + y * y + z * z - 1));
    leastScalar = Math.min(leastScalar, w);
    const degrees = (Math.atan2(Math.hypot(x, y, z), w) * 360) / Math.PI;
    sums.within90 += degrees < 90 ? 1 : 0;
    sums.within45 += degrees < 45 ? 1 : 0;
    sums.xx += x * x;
    sums.zz += z * z;
    sums.xy += x * y;
    // Where the body's z axis points.
    sums.aboveTheEquator += 1 - 2 * (x * x + y * y) > 0.5 ? 1 : 0;
  }
  expect(worstNorm).toBeLessThan(1e-15);
  expect(leastScalar).toBeGreaterThanOrEqual(0);
  // The angle has the density (1 − cos θ)/π, an axis of the body that of the sphere. Four standard
  // deviations of 20 000 draws.
  const expectNear = (sum: number, expected: number) =>
    expect(Math.abs(sum / count - expected)).toBeLessThan(4 * 0.5 * count ** -0.5);
  expectNear(sums.within90, 0.5 - 1 / Math.PI);
  expectNear(sums.within45, 0.25 - Math.SQRT1_2 / Math.PI);
  expectNear(sums.xx, 0.25);
  expectNear(sums.zz, 0.25);
  expectNear(sums.xy, 0);
  expectNear(sums.aboveTheEquator, 0.25);
});

test("the random example is another one each time that the gallery is opened", async ({ page }) => {
  await page.goto("/");
  const drawn = async () => {
    await page.getByRole("button", { name: moreExamples }).click();
    const dialog = page.getByRole("dialog", { name: "Examples" });
    await dialog.getByRole("link", { name: "A random attitude" }).press("Enter");
    await expect(dialog).toBeHidden();
    await expect(page.locator(".problem")).toHaveCount(0);
    return quaternionField(page).inputValue();
  };
  const first = await drawn();
  expect(first).toMatch(/^w: 0\.\d+(e-\d+)?, x: -?0\.\d+/);
  expect(await drawn()).not.toBe(first);
});
