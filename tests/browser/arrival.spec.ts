// A part of the page that does not arrive: words in its place, and a way to try again.
import { expect, type Route, test } from "@playwright/test";
import { matrix } from "./support/page.ts";

const notFound = (route: Route) => route.fulfill({ status: 404, body: "not found" });
const html = (route: Route) => route.fulfill({ contentType: "text/html", body: "<p>Hello</p>" });
/** As a browser that is too old finds it. */
const unreadable = (route: Route) =>
  route.fulfill({ contentType: "text/javascript", body: "const of = ;" });

for (const [what, part, answer] of [
  ["the main script is gone, as after a deploy", "**/index-*.js", notFound],
  ["the script that all share is gone", "**/preact-*.js", notFound],
  ["the host answers every address with a page", "**/index-*.js", html],
  ["the connection breaks", "**/preact-*.js", (route: Route) => route.abort()],
  ["the script cannot be read", "**/index-*.js", unreadable],
] as const) {
  test(`words and a way to try again where ${what}`, async ({ page }) => {
    await page.route(part, answer);
    await page.goto("/#read?quaternion=0+0+0.6+0.8");
    await expect(page.getByRole("alert")).toContainText("The playground could not start");
    await expect(page.getByText("Loading the playground")).toBeHidden();
    await page.unroute(part);
    await page.getByRole("button", { name: "Try again" }).click();
    await expect(matrix(page, "R(q)")).toBeVisible();
    await expect(page).toHaveURL(/quaternion=0\+0\+0\.6\+0\.8/);
    await expect(page.getByRole("alert")).toHaveCount(0);
  });
}

test("without scripts only the line stands that says so", async ({ browser, baseURL }) => {
  const context = await browser.newContext({ javaScriptEnabled: false });
  const page = await context.newPage();
  await page.goto(baseURL ?? "");
  await expect(page.locator("noscript p")).toBeVisible();
  await expect(page.getByText("Loading the playground")).toBeHidden();
  await expect(page.getByText("could not start")).toBeHidden();
  await context.close();
});
