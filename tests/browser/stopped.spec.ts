// A core that cannot be loaded says why, and one that stops is made anew: nothing is permanent.
import { type Page, test as unwatched } from "@playwright/test";
import { answering, CoreStopped, calling } from "../../www/package/answering.ts";
import { expect, matrix, numbersOf, quaternionField, test } from "./support/page.ts";

const quarterTurn = [0, -1, 0, 1, 0, 0, 0, 0, 1];

/** The first instance of a core stops at every call after so many. */
async function stopAfter(page: Page, calls: number) {
  await page.addInitScript((calls) => {
    const instantiate = WebAssembly.instantiateStreaming;
    WebAssembly.instantiateStreaming = async (...given) => {
      const { instance, module } = await instantiate(...given);
      const exported = instance.exports as Record<string, (...given: unknown[]) => unknown>;
      let left = calls;
      const analyze = (...given: unknown[]) => {
        left -= 1;
        if (left < 0) throw new WebAssembly.RuntimeError("unreachable");
        return exported["analyze"]?.(...given);
      };
      const stopping = { exports: { ...exported, analyze } } as unknown as WebAssembly.Instance;
      return { instance: stopping, module };
    };
  }, calls);
}

for (const address of ["/", "/#translate"]) {
  test(`after a trap the page goes on with a new instance: ${address}`, async ({ page }) => {
    await stopAfter(page, 3);
    await page.goto(address);
    await expect(quaternionField(page)).toBeVisible();
    const failure = page.locator(".failure");
    // A text is asked once, and each of these is another one.
    let at = 0;
    await expect(async () => {
      at += 1;
      await quaternionField(page).fill(`0 0 0 ${at}`);
      expect(await failure.count()).toBe(1);
    }).toPass();
    await expect(failure).toContainText("RuntimeError: unreachable");
    await quaternionField(page).fill("0 0 0.6 0.8");
    await expect(failure).toHaveCount(0);
    await page.goto("/#read?quaternion=90deg+about+z");
    await expect.poll(() => numbersOf(matrix(page, "R(q)"))).toEqual(quarterTurn);
    await expect(failure).toHaveCount(0);
  });
}

unwatched("after a trap whatever is called next has a new instance", () => {
  const done: string[] = [];
  const core = {
    analyze: () => {
      throw new WebAssembly.RuntimeError("unreachable");
    },
    startAnew: () => void done.push("anew"),
    takePanicMessage: () => undefined,
  };
  const call = calling(core);
  expect(() => answering(core, call)({})).toThrow(CoreStopped);
  call(() => done.push("described"));
  call(() => done.push("described again"));
  expect(done).toEqual(["anew", "described", "described again"]);
});

const notStarted = (page: Page) => page.locator("[data-not-started]");
const advice = "wasm-unsafe-eval";
const wasm = "**/quatlas_small_bg-*.wasm";

unwatched("a policy that forbids the core is told as such", async ({ page }) => {
  await page.route("/", async (route) => {
    const response = await route.fetch();
    const headers = {
      ...response.headers(),
      "Content-Security-Policy": "script-src 'self'; object-src 'none'",
    };
    await route.fulfill({ response, headers });
  });
  await page.goto("/");
  await expect(notStarted(page)).toContainText(`must allow '${advice}'`);
});

for (const [what, answer] of [
  ["is missing", { status: 404, contentType: "text/plain", body: "not here" }],
  ["is damaged", { status: 200, contentType: "application/wasm", body: "\0asm, but no more" }],
  ["is another file", { status: 200, contentType: "text/html", body: "<p>csp, policy</p>" }],
] as const) {
  unwatched(`a core that ${what} is told without advice about a policy`, async ({ page }) => {
    await page.route(wasm, (route) => route.fulfill(answer));
    await page.goto("/");
    await expect(notStarted(page)).toContainText("The core could not be loaded");
    await expect(notStarted(page)).not.toContainText(advice);
  });
}

unwatched("a core that does not arrive is told without advice about a policy", async ({ page }) => {
  await page.route(wasm, (route) => route.abort());
  await page.goto("/");
  await expect(notStarted(page)).toContainText("The core could not be loaded");
  await expect(notStarted(page)).not.toContainText(advice);
});

// Unwatched, because a browser asks for an icon of a text.
unwatched("the licences of all that the page holds are one link away", async ({ page }) => {
  for (const address of ["/", "/#translate", "/#libraries"]) {
    await page.goto(address);
    await expect(page.getByRole("link", { name: "Licences" })).toBeVisible();
  }
  await page.getByRole("link", { name: "Licences" }).click();
  for (const text of ["preact", "SIL OPEN FONT LICENSE", "twofloat", "quatlas"]) {
    await expect(page.locator("body")).toContainText(text);
  }
});
