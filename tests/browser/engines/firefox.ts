// Firefox as people have it, over WebDriver BiDi: Playwright drives a Firefox of its own making only.
import { launch } from "puppeteer-core";
import { draggedBy, type Engine, heightPx, type Point } from "./engine.ts";

export interface Firefox extends Engine {
  /** A finger goes down at the first place, over the others, and up at the last. */
  swipe(...places: Point[]): Promise<void>;
}

export async function startFirefox(preferences: Record<string, unknown> = {}): Promise<Firefox> {
  const executablePath = process.env["QUATLAS_FIREFOX"];
  if (!executablePath) throw new Error("QUATLAS_FIREFOX has no path of a Firefox");
  const browser = await launch({
    browser: "firefox",
    executablePath,
    extraPrefsFirefox: preferences,
  });
  const page = await browser.newPage();
  const consoleErrors: string[] = [];
  page.on("console", (message) => {
    if (message.type() === "error") consoleErrors.push(message.text());
  });
  page.on("pageerror", (error) => consoleErrors.push(String(error)));
  const { keyboard, mouse, touchscreen } = page;
  const widen = (width: number) => page.setViewport({ width, height: heightPx });
  return {
    consoleErrors,
    widen,
    open: async (address, width) => {
      await widen(width);
      await page.goto("about:blank");
      await page.goto(address);
    },
    reload: async () => void (await page.reload()),
    evaluate: (run, argument) => page.evaluate(run as never, argument as never),
    type: (text) => keyboard.type(text),
    press: async (...keys) => {
      for (const key of keys) await keyboard.down(key);
      for (const key of keys.toReversed()) await keyboard.up(key);
    },
    drag: draggedBy(mouse),
    swipe: async (...places) => {
      const [{ x, y } = { x: 0, y: 0 }, ...others] = places;
      const finger = await touchscreen.touchStart(x, y);
      for (const place of others) await finger.move(place.x, place.y);
      await finger.end();
    },
    close: () => browser.close(),
  };
}
