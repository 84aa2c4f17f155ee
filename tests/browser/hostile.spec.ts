// Whatever the address or a field holds, the page lives on and nothing of it becomes markup or script.
import type { Page } from "@playwright/test";
import { hostileFragments, hostileTexts } from "./support/hostile_fragments.ts";
import { expect, matrix, numbersOf, quaternionField, test } from "./support/page.ts";
import { violationsOf, watchViolations } from "./support/violations.ts";

/** Longer than this, and the page is as good as dead. */
const answerMs = 10_000;

interface Looked {
  view: string;
  title: string;
  /** Elements that nothing typed may make. */
  foreign: number;
  isEditable: boolean;
  /** Words that only a mistake of the page would show. */
  slips: readonly string[];
  length: number;
}

/** What a visitor finds in the page. */
function look(): Looked {
  const main = document.querySelector("main");
  // The tab, and the part of it that is the view.
  const current = document.querySelectorAll("a[aria-current=page]");
  const field = main?.querySelector<HTMLTextAreaElement>("textarea, input");
  const text = main?.innerText ?? "";
  return {
    view: [...current].at(-1)?.getAttribute("href")?.match(/\w+/)?.[0] ?? "",
    title: document.title,
    foreign: document.querySelectorAll(
      "img, iframe, object, embed, base, form, frame, [onerror], [onload], [onfocus], [srcdoc], a[href^='javascript']",
    ).length,
    isEditable: field != null && !field.disabled && !field.readOnly,
    slips: text.match(/\bNaN\b|\bundefined\b|\[object|(?<![\d.])[-−]0(?![\d.])/g) ?? [],
    length: text.length,
  };
}

async function expectAlive(page: Page, view: string, hasWords: boolean) {
  // A view that is loaded when it is opened has a line in its place until then, and so has a text that only
  // the whole core may read.
  await expect(page.locator("main :is(.loading, .reading)")).toHaveCount(0);
  const looked = await page.evaluate(look);
  expect(looked).toMatchObject({ view, foreign: 0, isEditable: true });
  expect(looked.title).toMatch(/quatlas/);
  expect(looked.length).toBeGreaterThan(300);
  // What was typed may hold such words; a complaint repeats them.
  if (!hasWords) expect(looked.slips).toEqual([]);
}

const hasWords = (text: string) => /NaN|undefined|-0|object/.test(text);

/** Changes the fragment as a link does, and waits until the page has followed. */
async function open(page: Page, fragment: string) {
  return page.evaluate(async (fragment) => {
    const started = performance.now();
    const before = location.href;
    const followed = new Promise((done) => addEventListener("hashchange", done, { once: true }));
    location.hash = fragment;
    if (location.href !== before) await followed;
    for (let frame = 0; frame < 2; frame += 1) await new Promise(requestAnimationFrame);
    return performance.now() - started;
  }, fragment);
}

test.describe.configure({ timeout: 240_000 });

const parts = 4;
for (let part = 0; part < parts; part += 1) {
  test(`a hostile address does no harm, part ${part + 1} of ${parts}`, async ({ page }) => {
    expect(hostileFragments.length).toBeGreaterThan(200);
    await watchViolations(page);
    await page.goto("/");
    await expect(matrix(page, "R(q)")).toBeVisible();
    const scripts = await page.locator("script").count();
    for (const { fragment, view } of hostileFragments.filter((_, at) => at % parts === part)) {
      await test.step(fragment.slice(0, 100), async () => {
        expect(await open(page, fragment)).toBeLessThan(answerMs);
        await expectAlive(page, view, hasWords(decoded(fragment)));
      });
    }
    expect(await page.locator("script").count()).toBe(scripts);
    expect(await violationsOf(page)).toEqual([]);
    await open(page, "read?quaternion=1+1+1+1");
    await expect.poll(() => numbersOf(matrix(page, "R(q)"))).toEqual([0, 0, 1, 1, 0, 0, 0, 1, 0]);
  });
}

function decoded(fragment: string) {
  try {
    return decodeURIComponent(fragment);
  } catch {
    return fragment;
  }
}

test("a hostile address does no harm to a page that starts with it", async ({ page }) => {
  await watchViolations(page);
  const every = Math.ceil(hostileFragments.length / 20);
  for (const { fragment, view } of hostileFragments.filter((_, at) => at % every === 0)) {
    await test.step(fragment.slice(0, 100), async () => {
      await page.goto("about:blank");
      await page.goto(`/#${fragment}`);
      await expect(page.locator(".views [aria-current=page]")).toBeVisible();
      await expectAlive(page, view, hasWords(decoded(fragment)));
      expect(await violationsOf(page)).toEqual([]);
    });
  }
});

test("a hostile text that is typed does no harm, and the address holds it", async ({ page }) => {
  await watchViolations(page);
  await page.goto("/");
  const typed = [...hostileTexts, "\ud800 \udc00\ud800", "1 0 0 \u0000", "(".repeat(100_000)];
  for (const text of typed) {
    await test.step(text.slice(0, 60), async () => {
      await quaternionField(page).fill(text);
      await expectAlive(page, "read", hasWords(text));
    });
  }
  expect(await violationsOf(page)).toEqual([]);
  const last = typed.at(-1) ?? "";
  await page.reload();
  await expect(quaternionField(page)).toHaveValue(last);
});

test("a change of the address is followed while what was typed waits to be written", async ({
  page,
}) => {
  await page.goto("/");
  await expect(matrix(page, "R(q)")).toBeVisible();
  await page.evaluate(async () => {
    const field = document.querySelector("textarea");
    if (field === null) throw new Error("no field");
    field.value = "1 2 3 4";
    field.dispatchEvent(new Event("input", { bubbles: true }));
    location.hash = "compose";
    // As long as the page waits, and more: the event comes only afterwards.
    const end = performance.now() + 400;
    while (performance.now() < end);
  });
  await expect(page.getByRole("textbox", { name: "quaternion p" })).toBeVisible();
});

test("what is typed just before a reload, or before leaving, is there again", async ({ page }) => {
  await page.goto("/");
  await expect(matrix(page, "R(q)")).toBeVisible();
  await quaternionField(page).fill("1 2 3 4");
  await page.reload();
  await expect(quaternionField(page)).toHaveValue("1 2 3 4");
  await quaternionField(page).fill("4 3 2 1");
  await page.goto("about:blank");
  await page.goBack();
  await expect(quaternionField(page)).toHaveValue("4 3 2 1");
  // Another address, opened in the same tab, is not overwritten.
  await quaternionField(page).fill("5 6 7 8");
  await page.goto("about:blank");
  await page.goto("/#read?quaternion=1+1+1+1");
  await expect(quaternionField(page)).toHaveValue("1 1 1 1");
});
