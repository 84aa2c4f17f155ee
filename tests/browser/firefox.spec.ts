// Firefox under a finger, in the dark and with less motion, as a system would ask it for them.
import { type Firefox, startFirefox } from "./engines/firefox.ts";
import {
  test as base,
  expect,
  middleOf,
  openView,
  quaternion,
  shown,
} from "./support/engine_test.ts";
import { fromX } from "./support/page.ts";

const preferences = {
  "ui.systemUsesDarkTheme": 1,
  "ui.prefersReducedMotion": 1,
  // A machine without a touchscreen has no events of it.
  "dom.w3c_touch_events.enabled": 1,
};

const test = base.extend<object, { firefox: Firefox }>({
  firefox: [
    // biome-ignore lint/correctness/noEmptyPattern: Playwright reads the names of the fixtures.
    async ({}, use) => {
      const firefox = await startFirefox(preferences);
      await use(firefox);
      await firefox.close();
    },
    { scope: "worker", timeout: 60_000 },
  ],
  started: [({ firefox }, use) => use(firefox), { scope: "worker" }],
});
test.describe.configure({ mode: "default", timeout: 120_000 });

const hasBody = () => document.querySelector(".stage .picture-body") !== null;

test("a finger turns the body, and the page stays", async ({ engine, firefox, site }) => {
  await openView(engine, `${site.url}#read?quaternion=1+0+0+0&${fromX}`, 390);
  await shown(engine, hasBody).toBe(true);
  const { x, y } = await engine.evaluate(middleOf, ".stage .picture-body");
  const scrolled = await engine.evaluate(() => scrollY);
  await firefox.swipe({ x, y }, { x, y: y - 20 }, { x, y: y - 60 });
  await shown(engine, quaternion).toMatch(/^\d+(?:\.\d+)?deg about -y$/);
  expect(await engine.evaluate(() => scrollY)).toBe(scrolled);
});

test("it is dark, and a change of the picture is shown at once", async ({ engine, site }) => {
  await openView(engine, `${site.url}#read?quaternion=90deg+about+z&vector=1+0+0`, 1280);
  await shown(engine, hasBody).toBe(true);
  const colours = await engine.evaluate(() => {
    const themeColour = document.querySelector("meta[data-theme=dark]")?.getAttribute("content");
    const sample = document.createElement("span");
    sample.style.color = themeColour ?? "";
    document.body.append(sample);
    const { color } = getComputedStyle(sample);
    sample.remove();
    return { paper: getComputedStyle(document.body).backgroundColor, dark: color };
  });
  expect(colours.paper).toBe(colours.dark);

  const drawings = await engine.evaluate(async () => {
    const picture = document.querySelector(".stage svg") as Element;
    const seen = new Set<string>();
    const watch = new MutationObserver(() => seen.add(picture.innerHTML));
    watch.observe(picture, { attributes: true, childList: true, subtree: true });
    document.querySelector<HTMLInputElement>("[name=reading][value=active]")?.click();
    for (let frames = 0; frames < 10; frames += 1) {
      await new Promise((painted) => requestAnimationFrame(painted));
    }
    watch.disconnect();
    return seen.size;
  });
  expect(drawings).toBe(1);
});
