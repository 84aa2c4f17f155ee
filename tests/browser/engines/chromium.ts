// Chromium, driven by Playwright.
import { chromium, type LaunchOptions } from "@playwright/test";
import { draggedBy, type Engine, heightPx } from "./engine.ts";

export async function startChromium(options: LaunchOptions): Promise<Engine> {
  const browser = await chromium.launch(options);
  const page = await browser.newPage({ serviceWorkers: "allow" });
  const consoleErrors: string[] = [];
  page.on("console", (message) => {
    if (message.type() === "error") consoleErrors.push(message.text());
  });
  page.on("pageerror", ({ message }) => consoleErrors.push(message));
  const widen = (width: number) => page.setViewportSize({ width, height: heightPx });
  return {
    consoleErrors,
    widen,
    open: async (address, width) => {
      await widen(width);
      await page.goto("about:blank");
      await page.goto(address);
    },
    reload: async () => void (await page.reload()),
    evaluate: (run, argument) => page.evaluate(run as never, argument),
    type: (text) => page.keyboard.type(text),
    press: (...keys) => page.keyboard.press(keys.join("+")),
    drag: draggedBy(page.mouse),
    close: () => browser.close(),
  };
}
