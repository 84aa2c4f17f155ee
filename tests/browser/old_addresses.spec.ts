// Thirty addresses of an earlier page, kept in tests/vectors/addresses.json: each opens what it opened
// then. It knows nothing of the layout, so that it holds through all that the page becomes.
import { readFileSync } from "node:fs";
import type { Page } from "@playwright/test";
import { analyze, initSync } from "../../pkg/quatlas.js";
import { fromFragment } from "../../www/address/fragment.ts";
import type { PageState } from "../../www/model/page_state.ts";
import { askedOf } from "./support/asked.ts";
import { expect, test } from "./support/page.ts";

const root = new URL("../../", import.meta.url);
initSync({ module: readFileSync(new URL("pkg/quatlas_bg.wasm", root)) });

interface Kept {
  fragment: string;
  /** Where the state differs from that of the opening. */
  state: Partial<PageState>;
  /** What the core answers: numbers, and names of what is settled. */
  answer: Record<string, unknown>;
  /** Texts that stand on the page, in its words or in its fields. */
  shown: string[];
}

const { opening, addresses }: { opening: PageState; addresses: Kept[] } = JSON.parse(
  readFileSync(new URL("tests/vectors/addresses.json", root), "utf8"),
);

/** Far more than rounding, far less than any misreading. */
const tolerance = 1e-12;

/** What is the state now may say more than it did, and nothing else. */
function expectState(state: PageState, { fragment, state: different }: Kept) {
  const before = { ...opening, ...different };
  // From where the picture is first looked at is no part of a case.
  if (!fragment.includes("look=")) before.picture = { ...before.picture, look: state.picture.look };
  expect(state, fragment).toMatchObject(before);
  expect(state.axes, fragment).toEqual(before.axes);
}

test("an address of an earlier page means the state that it meant", () => {
  expect(addresses).toHaveLength(30);
  expect(opening.view).toBe("read");
  for (const kept of addresses) expectState(fromFragment(kept.fragment), kept);
});

test("an address of an earlier page has the numbers that it had", () => {
  for (const { fragment, answer } of addresses) {
    const now = answerOf(fromFragment(fragment));
    expect(Object.keys(now), fragment).toEqual(Object.keys(answer));
    expectNear(now, answer, fragment);
  }
});

/** Numbers within the tolerance, and all else as it was. */
function expectNear(now: unknown, before: unknown, at: string) {
  if (typeof before === "number") {
    expect(Math.abs(Number(now) - before), `${at}: ${now}`).toBeLessThanOrEqual(tolerance);
  } else if (typeof before === "object" && before !== null) {
    for (const [name, value] of Object.entries(before)) {
      expectNear((now as Record<string, unknown>)[name], value, `${at} ${name}`);
    }
  } else expect(now, at).toEqual(before);
}

function answerOf(state: PageState): Record<string, unknown> {
  const request = askedOf(state);
  const outcome = request && analyze(request);
  switch (outcome?.status) {
    case "problems":
      return { problems: outcome.problems.map(({ field }) => field) };
    case "read":
      return {
        declared: outcome.declared.quaternion.array,
        rotation: outcome.hamilton.matrix.flat(),
        image: outcome.hamilton.image,
        angleDeg: outcome.turn.angleDeg,
        eulerDeg: outcome.euler.anglesDeg,
      };
    case "compose":
      return {
        product: outcome.declared.quaternion.array,
        matrix: outcome.declared.matrix.flat(),
        images: outcome.declared.images,
      };
    case "translate":
      return {
        to: outcome.to.array,
        ...(outcome.to.matrix && { matrix: outcome.to.matrix.rows.flat() }),
        angleDeg: outcome.turn.angleDeg,
      };
    case "identify":
      return {
        possible: outcome.possible,
        settled: outcome.settled,
        ...(outcome.family && { family: outcome.family }),
      };
    default:
      return {};
  }
}

test("the page opens an address of an earlier page, one after the other", async ({ page }) => {
  test.slow();
  await page.goto("./");
  for (const kept of addresses) {
    await page.evaluate((fragment) => {
      location.hash = fragment;
    }, kept.fragment);
    const view = kept.state.view ?? opening.view;
    const link = page.locator(`a[aria-current="page"][href^="#${view}"]`).first();
    await expect(link, kept.fragment).toBeVisible();
    await expect.poll(() => missing(page, kept.shown), kept.fragment).toEqual([]);
    expectState(fromFragment(await writtenAddress(page)), kept);
  }
});

/** Which of some texts stand nowhere in the view. */
function missing(page: Page, texts: string[]): Promise<string[]> {
  return page.evaluate((texts) => {
    const main = document.querySelector("main");
    const fields = main?.querySelectorAll<HTMLInputElement>("input, textarea") ?? [];
    const shown = [main?.textContent, ...[...fields].map(({ value }) => value)].join("\n");
    return texts.filter((text) => !shown.includes(text));
  }, texts);
}

/** The address as the page itself writes its state, which it does before any click acts. */
function writtenAddress(page: Page): Promise<string> {
  return page.evaluate(() => {
    document.body.dispatchEvent(new MouseEvent("click"));
    return location.hash;
  });
}
