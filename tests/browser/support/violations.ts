// What the content-security policy refuses, noted from the first script on.
import type { Page } from "@playwright/test";

export async function watchViolations(page: Page) {
  await page.addInitScript(() => {
    const refused: string[] = [];
    Object.assign(window, { refused });
    addEventListener("securitypolicyviolation", ({ violatedDirective, blockedURI }) =>
      refused.push(`${violatedDirective} ${blockedURI}`),
    );
  });
}

export const violationsOf = (page: Page) =>
  page.evaluate(() => (window as unknown as { refused: string[] }).refused);
