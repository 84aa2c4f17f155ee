// What the page loads, when, and how much of it; and that nothing moves meanwhile.
import { type Page, test as plainTest } from "@playwright/test";
import { brotliOf, gzipTotal, missingParts, partsOfPage } from "../../www/tasks/page_parts.mjs";
import {
  expect,
  haveNoLetters,
  holdBack,
  matrix,
  numbersOf,
  part,
  quaternionField,
  tab,
  test,
} from "./support/page.ts";

/** Compressed bytes: what was measured, and 3 %. */
const firstBudget = 177_500;
const lazyBudgets: Record<string, number> = {
  "Atlas.css": 390,
  "Atlas.js": 1_640,
  "AxesPanel.js": 830,
  "Between.css": 375,
  "Between.js": 2_870,
  "Chain.css": 230,
  "Chain.js": 2_230,
  "Compose.css": 1_550,
  "Compose.js": 3_600,
  "ComposePicture.css": 410,
  "ComposePicture.js": 1_490,
  "CopyMenu.css": 450,
  "CopyMenu.js": 870,
  "FoldedBody.css": 255,
  "FoldedBody.js": 1_310,
  "Frames.css": 1_130,
  "Frames.js": 5_550,
  "FramesPicture.js": 1_160,
  "Gallery.css": 350,
  "Gallery.js": 2_610,
  "Help.css": 460,
  "Help.js": 1_400,
  "Identify.css": 2_550,
  "Identify.js": 11_920,
  "Libraries.css": 1_770,
  "Libraries.js": 5_230,
  "Matrices.css": 200,
  "Matrices.js": 1_980,
  "Motion.css": 1_110,
  "Motion.js": 5_960,
  "MotionPicture.js": 1_740,
  "OfVectors.js": 1_150,
  "Popup.css": 180,
  "Popup.js": 810,
  "ReadPicture.js": 2_530,
  "RulesList.css": 130,
  "RulesList.js": 680,
  "SharePanel.css": 350,
  "SharePanel.js": 860,
  "Stage.js": 7_000,
  "SwingTwist.js": 790,
  "Translate.css": 1_830,
  "Translate.js": 10_070,
  "apple_touch_icon.png": 3_140,
  "asked.css": 510,
  "asked.js": 600,
  "axes_panel.css": 500,
  "axes_panel.js": 310,
  "case_title.js": 1_830,
  "code.js": 3_780,
  "favicon.svg": 330,
  "icon_192.png": 5_510,
  "icon_512.png": 15_040,
  "icon_maskable_512.png": 7_920,
  "libraries.js": 33_540,
  "library.js": 1_930,
  "library_search.js": 510,
  "licences.txt": 12_950,
  "manifest.webmanifest": 400,
  "mistakes.js": 570,
  "motion.js": 320,
  "observations.js": 21_670,
  "offline.css": 420,
  "offline.js": 630,
  "phrases.js": 220,
  "quatlas.js": 2_750,
  "quatlas_bg.wasm": 315_000,
  "save.js": 710,
  "service_worker.js": 5_390,
  "whole_notes.js": 1_240,
};

const firstParts = ["index.html", "index.js", "preact.js", "quatlas_small_bg.wasm"];

/** What no part may pass, whatever it is worth. */
const goals = {
  "index.html": 16_000,
  "quatlas_small_bg.wasm": 118_000,
  // It reads whole blocks, and numbers that are to be identified; the formats as data are 9 kB of it.
  "quatlas_bg.wasm": 315_000,
};
/** All that is loaded until typing is answered. */
const firstGoals = { gzip: 184_000, brotli: 163_000 };

test("the first load is within its budget", () => {
  const { first } = partsOfPage();
  expect(first.map(({ name }) => name).sort()).toEqual(firstParts);
  expect(gzipTotal(first)).toBeLessThanOrEqual(firstBudget);
  expect(firstBudget).toBeLessThanOrEqual(firstGoals.gzip);
  const brotli = first.reduce((sum, part) => sum + brotliOf(part), 0);
  expect(brotli).toBeLessThanOrEqual(firstGoals.brotli);
});

test("what stands before the first result, and each core, is no heavier than its goal", () => {
  const { first, lazy } = partsOfPage();
  for (const [name, most] of Object.entries(goals)) {
    const part = [...first, ...lazy].find((part) => part.name === name);
    expect(part?.gzip, name).toBeLessThanOrEqual(most);
  }
});

test("every part that is loaded later has a budget, and is within it", () => {
  const { lazy } = partsOfPage();
  const names = lazy.map(({ name }) => name).sort();
  expect(names).toEqual(Object.keys(lazyBudgets).sort());
  for (const { name, gzip } of lazy) {
    expect(gzip, name).toBeLessThanOrEqual(lazyBudgets[name] ?? 0);
  }
});

/** The names of the files that the page asks for from now on. */
function requested(page: Page): string[] {
  const files: string[] = [];
  page.on("request", (request) => {
    files.push(new URL(request.url()).pathname.split("/").at(-1) || "index.html");
  });
  return files;
}

/** What follows the first result by itself: the picture, the folds, Compose, and what keeps the page for offline use. */
const afterResult = [
  ...[
    "ReadPicture.js",
    "ComposePicture.js",
    "ComposePicture.css",
    "Stage.js",
    "motion.js",
    "save.js",
    "case_title.js",
  ],
  ...["FoldedBody.js", "FoldedBody.css", "Compose.js", "Compose.css"],
  ...["AxesPanel.js", "axes_panel.js", "axes_panel.css", "RulesList.js", "RulesList.css"],
  ...["offline.js", "offline.css", "favicon.svg"],
];

test("a bare address loads only the first load, and after the result the picture", async ({
  page,
}) => {
  const files = requested(page);
  await page.goto("./", { waitUntil: "networkidle" });
  const { first, fonts, lazy } = partsOfPage();
  const followers = lazy.filter(({ name }) => afterResult.includes(name));
  const known = [...first, ...fonts, ...followers].map(({ file }) => file);
  expect(files.filter((file) => !known.includes(file))).toEqual([]);
  await tab(page, "Compose").click();
  await expect(matrix(page, "R(p ⊙ q)")).toBeVisible();
  expect(files.filter((file) => !known.includes(file))).toEqual([]);
});

test("an address that opens a later view loads the whole core and not the small one", async ({
  page,
}) => {
  const files = requested(page);
  await page.goto("./#libraries?library=eigen", { waitUntil: "networkidle" });
  await expect(page.getByRole("table")).toBeVisible();
  expect(files.filter((file) => file.startsWith("quatlas_bg"))).toHaveLength(1);
  expect(files.filter((file) => file.startsWith("quatlas_small_bg"))).toEqual([]);
});

test("the whole core and the table of libraries are asked for at once", async ({ page }) => {
  const both = [page.waitForRequest(/quatlas_bg-/), page.waitForRequest(/libraries-/)];
  await page.route(/quatlas_bg-|libraries-/, async (route) => {
    await Promise.all(both);
    await route.continue();
  });
  await page.goto("./#libraries?library=eigen");
  await expect(page.getByRole("table")).toBeVisible();
});

test("the whole core takes over what was typed for the small one", async ({ page }) => {
  await page.goto("./#read?from=nowhere&to=eigen");
  await quaternionField(page).fill("0.6 0 0 0.8");
  const before = await numbersOf(matrix(page, "R(q)"));
  await tab(page, "Libraries").click();
  await expect(page.getByRole("textbox", { name: "quaternion q" })).toHaveValue(/0\.1/);
  // An end that is no library is that of the opening.
  await expect(page).toHaveURL(/to=eigen/);
  await expect(page).not.toHaveURL(/nowhere/);
  await tab(page, "Read").click();
  await expect(quaternionField(page)).toHaveValue("0.6 0 0 0.8");
  expect(await numbersOf(matrix(page, "R(q)"))).toEqual(before);
});

for (const [width, letters] of [
  [1280, "its letters"],
  [390, "its letters"],
  [1280, "those of the system"],
  [390, "those of the system"],
] as const) {
  test(`nothing moves while the page loads and is typed into, ${width} wide in ${letters}`, async ({
    page,
  }) => {
    if (letters === "those of the system") await haveNoLetters(page);
    // So high that nothing moves out of sight.
    await page.setViewportSize({ width, height: 2400 });
    await page.addInitScript(watchShifts);
    for (const view of [
      "compose",
      "motion",
      "frames",
      "translate",
      "identify",
      "libraries",
      "read",
    ]) {
      // Another document each time, not a change of view.
      await page.goto("about:blank");
      await page.goto(`./#${view}`, { waitUntil: "networkidle" });
      await expect(page.locator("main .loading")).toHaveCount(0);
      expect(await page.evaluate(cumulativeShift), view).toBe(0);
    }
    await quaternionField(page).focus();
    await page.keyboard.press("ControlOrMeta+a");
    for (const key of "0.92 + 0.38k") await page.keyboard.press(key === " " ? "Space" : key);
    await expect(page.getByRole("textbox", { name: "Hamilton q, z" })).toHaveValue("0.380000");
    expect(await page.evaluate(cumulativeShift)).toBe(0);
  });
}

/**
 * Browsers count what moves by itself, and not what moves in the half second after a key. At a rest of the hand
 * the page takes the room that it needs for what is said (dom/hold.ts), which is meant, and on a busy machine
 * may come later than that: so they are watched until then.
 */
function watchShifts() {
  const watched = globalThis as { shift?: number };
  watched.shift = 0;
  const count = (entries: PerformanceEntryList) => {
    for (const entry of entries as (PerformanceEntry & LayoutShift)[]) {
      if (!entry.hadRecentInput) watched.shift = (watched.shift ?? 0) + entry.value;
    }
  };
  const shifts = new PerformanceObserver((list) => count(list.getEntries()));
  shifts.observe({ type: "layout-shift", buffered: true });
  new MutationObserver((changes) => {
    if (!changes.some(({ oldValue }) => oldValue?.includes("typing"))) return;
    if (document.querySelector(".ask-status.typing") !== null) return;
    count(shifts.takeRecords());
    shifts.disconnect();
  }).observe(document, { subtree: true, attributeFilter: ["class"], attributeOldValue: true });
}

interface LayoutShift {
  value: number;
  hadRecentInput: boolean;
}

/** After the frames in which the last change is painted. */
async function cumulativeShift() {
  for (const _ of [1, 2]) await new Promise((painted) => requestAnimationFrame(painted));
  return (globalThis as { shift?: number }).shift;
}

test("an unfinished number moves nothing below the field", async ({ page }) => {
  await page.goto("./");
  const result = page.locator(".result .columns");
  await quaternionField(page).fill("0.92 + 0.38k");
  const before = await result.evaluate((node) => node.getBoundingClientRect().top);
  await quaternionField(page).fill("0.92 + 0.38k + ");
  await expect(page.locator(".result")).toHaveClass(/old/);
  expect(await result.evaluate((node) => node.getBoundingClientRect().top)).toBe(before);
});

plainTest("scripts and styles name no file that is not there", () => {
  expect(missingParts()).toEqual([]);
});

plainTest("a view that cannot be loaded says so, and is loaded on request", async ({ page }) => {
  await page.goto("./");
  await quaternionField(page).fill("0.6 0 0 0.8");
  await page.route("**/quatlas_bg-*.wasm", (route) => route.abort());
  await tab(page, "Libraries").click();
  await part(page, "Identify").click();
  await expect(page.getByRole("alert")).toContainText("Identify could not be loaded");
  await tab(page, "Read").click();
  await expect(quaternionField(page)).toHaveValue("0.6 0 0 0.8");
  await page.unroute("**/quatlas_bg-*.wasm");
  await tab(page, "Libraries").click();
  await expect(page.getByText("ij = −k and yet not JPL")).toBeVisible();
});

test("what the first core cannot read the whole one reads, and until then nothing is said", async ({
  page,
}) => {
  await page.goto("./");
  const allow = await holdBack(page, "**/quatlas_bg-*.wasm");
  await quaternionField(page).fill("0.6 0 0 oops");
  await expect(page.getByText("Reading …")).toBeVisible();
  await expect(page.locator(".problem")).toHaveCount(0);
  await expect(page.locator(".result")).toHaveClass(/old/);
  // What the first core reads it still answers.
  await quaternionField(page).fill("0 0 0.6 0.8");
  await expect(page.getByText("Reading …")).toHaveCount(0);
  await expect(page.locator(".result")).toHaveClass(/current/);
  await quaternionField(page).fill("Quaternionf(0.8, 0, 0, 0.6");
  await expect(page.getByText("Reading …")).toBeVisible();
  allow();
  await expect(page.locator(".problem")).toContainText("is never closed");
  await expect(page.getByText("Reading …")).toHaveCount(0);
});

plainTest(
  "where the whole core does not come the kind and the place of a problem are told",
  async ({ page }) => {
    await page.route("**/quatlas_bg-*.wasm", (route) => route.abort());
    await page.goto("./#read?quaternion=0.6+0+0+oops");
    const problem = page.locator(".problem");
    await expect(problem).toContainText("unknown-word");
    await expect(page.locator("mark")).toHaveText("oops");
    await expect(quaternionField(page)).toHaveValue("0.6 0 0 oops");
    await page.unroute("**/quatlas_bg-*.wasm");
    await problem.getByRole("button", { name: "try again" }).click();
    await expect(problem).toContainText("Expected:");
  },
);

test("of a link that only the whole core reads nothing but its answer is shown", async ({
  page,
}) => {
  const cores: string[] = [];
  page.on("request", (request) => {
    const core = /quatlas_(?:small_)?bg/.exec(request.url());
    if (core) cores.push(core[0]);
  });
  await page.addInitScript(() => {
    const seen = new Set<string>();
    Object.assign(globalThis, { seen });
    new MutationObserver(() => {
      const isShown = document.documentElement.dataset["case"] === undefined;
      const field = document.querySelector("textarea");
      const result = document.querySelector(".result");
      if (isShown && field && result) seen.add(`${field.value}: ${result.className}`);
    }).observe(document, { subtree: true, childList: true, attributes: true });
  });
  await page.goto("./#read?quaternion=Rotation.from_quat([0,0,0.6,0.8])");
  await expect(page.locator(".result")).toHaveClass(/current/);
  expect(cores).toEqual(["quatlas_small_bg", "quatlas_bg"]);
  const seen = await page.evaluate(() => [
    ...(globalThis as unknown as { seen: Set<string> }).seen,
  ]);
  expect(seen).toEqual(["Rotation.from_quat([0,0,0.6,0.8]): result current"]);
});
