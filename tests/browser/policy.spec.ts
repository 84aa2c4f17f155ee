// The content-security policy: as wanted, obeyed by every view, and refusing what is foreign.
import { createHash } from "node:crypto";
import { test as unwatched } from "@playwright/test";
import { expect, openEverything, quaternionField, test } from "./support/page.ts";
import { violationsOf, watchViolations } from "./support/violations.ts";

/** As a policy names what stands in the page itself. */
const hashOf = ([, content = ""]: readonly string[]) =>
  `'sha256-${createHash("sha256").update(content).digest("base64")}'`;

/** The policy of a page, with the hashes of its own script and styles. */
const policyOf = (html: string) =>
  [
    "default-src 'none'",
    [
      "script-src 'self'",
      ...[...html.matchAll(/<script>(.*?)<\/script>/gs)].map(hashOf),
      "'wasm-unsafe-eval'",
    ].join(" "),
    ["style-src 'self'", ...[...html.matchAll(/<style[^>]*>(.*?)<\/style>/gs)].map(hashOf)].join(
      " ",
    ),
    "img-src 'self' data: blob:",
    "font-src 'self'",
    "connect-src 'self'",
    "manifest-src 'self'",
    "worker-src 'self'",
    "base-uri 'none'",
    "form-action 'none'",
  ].join("; ");

test("the policy stands in the page before anything it governs", async ({ page }) => {
  const answer = await page.goto("/");
  const html = (await answer?.text()) ?? "";
  const [start = ""] = html.split(/<script|<style|<link|<title/);
  expect(start).toContain(`<meta http-equiv="Content-Security-Policy" content="${policyOf(html)}"`);
  // One script and, beside the letters, one style: what else stands there is files of the page.
  expect(html.match(/'sha256-/g)).toHaveLength(3);
  expect(html).not.toContain("unsafe-inline");
});

for (const address of [
  ...["/", "/#compose", "/#translate", "/#identify", "/#libraries"],
  "/#read?quaternion=1+0+oops",
]) {
  test(`nothing of the page violates its policy: ${address}`, async ({ page }) => {
    await watchViolations(page);
    await page.goto(address);
    const fields = page
      .locator("main")
      .locator("textarea, input:not([type=radio], [type=checkbox])");
    await expect(fields.first()).toBeVisible();
    await openEverything(page);
    await fields.first().fill("1/2 + i/2 + j/2 + k/2");
    await page.waitForLoadState("networkidle");
    expect(await violationsOf(page)).toEqual([]);
  });
}

unwatched(
  "a script, a handler, a style, an address and an eval that are injected do nothing",
  async ({ page }) => {
    await watchViolations(page);
    await page.goto("/");
    await expect(quaternionField(page)).toBeVisible();
    const evaluated = await page.evaluate(() => {
      const script = document.createElement("script");
      script.textContent = "document.title = 'script'";
      document.body.append(script);
      const foreign = document.createElement("script");
      foreign.src = "data:text/javascript,document.title='foreign'";
      document.body.append(foreign);
      const holder = document.createElement("div");
      holder.innerHTML = `
      <img src="data:image/png;base64,none" onerror="document.title = 'handler'">
      <style>body { display: none }</style>
      <a href="javascript:document.title = 'address'">go</a>
      <iframe src="data:text/html,hello"></iframe>
      <base href="https://quatlas.invalid/">`;
      document.body.append(holder);
      holder.querySelector("a")?.click();
      // What a test evaluates may evaluate; a timer of the page may not.
      return new Promise((done) => {
        setTimeout(() => {
          try {
            const { eval: evaluate } = window as unknown as Record<
              string,
              (text: string) => unknown
            >;
            done(evaluate?.("1 + 1"));
          } catch (error) {
            done((error as Error).name);
          }
        });
      });
    });
    expect(evaluated).toBe("EvalError");
    await expect
      .poll(async () => [...new Set(await violationsOf(page))].sort())
      .toEqual([
        "base-uri https://quatlas.invalid/",
        expect.stringMatching(/^frame-src/),
        "script-src eval",
        "script-src-attr inline",
        "script-src-elem data",
        "script-src-elem inline",
        "style-src-elem inline",
      ]);
    await expect(page).toHaveTitle(/quatlas/);
    await expect(quaternionField(page)).toBeVisible();
    const sent = await page.evaluate(() =>
      fetch("https://quatlas.invalid/").then(
        () => "sent",
        () => "refused",
      ),
    );
    expect(sent).toBe("refused");
    expect((await violationsOf(page)).at(-1)).toMatch(/^connect-src/);
  },
);
