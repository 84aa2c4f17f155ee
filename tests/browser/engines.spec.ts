// What matters most, in every engine. Each is started once, and nothing here asks which one it is but
// the last of the numbers.
import type { Engine } from "./engines/engine.ts";
import {
  click,
  expect,
  matrices,
  middleOf,
  openView,
  quaternion,
  shown,
  test,
  words,
} from "./support/engine_test.ts";
import { fromX } from "./support/page.ts";
import { addresses, cutNumbers } from "./support/whole_numbers.ts";

test.describe.configure({ mode: "default", timeout: 180_000 });

const aboutZ = {
  "R(q)": "0.707107 −0.707107 0 0.707107 0.707107 0 0 0 1",
  "C(q)": "0.707107 0.707107 0 −0.707107 0.707107 0 0 0 1",
};
/** x to y, y to z, z to x. */
const thirdTurn = "0 0 1 1 0 0 0 1 0";

/** To be run in the page. */
const coresAskedFor = () =>
  performance.getEntriesByType("resource").filter(({ name }) => name.endsWith(".wasm")).length;

const control = process.platform === "darwin" ? "Meta" : "Control";

async function selectQuaternion(engine: Engine) {
  await click(engine, "textarea[name=quaternion]");
  await engine.press(control, "a");
}

test("opens on 45° about z, follows what is typed, and copies what can be pasted", async ({
  engine,
  site,
}) => {
  await openView(engine, site.url, 1280);
  expect(await engine.evaluate(matrices)).toMatchObject(aboutZ);
  expect(await engine.evaluate(cutNumbers)).toEqual([]);
  // Asked for by the first script, and not again by the program.
  expect(await engine.evaluate(coresAskedFor)).toBe(1);

  await selectQuaternion(engine);
  await engine.type("1/2 + i/2 + j/2 + k/2");
  await shown(engine, matrices).toMatchObject({ "R(q)": thirdTurn });

  await click(engine, '[aria-label^="Copy R(q)"]');
  await shown(engine, words).toContain("R(q) copied");
  await selectQuaternion(engine);
  await engine.press(control, "v");
  await shown(engine, quaternion).toBe("[[0, 0, 1], [1, 0, 0], [0, 1, 0]]");
  await shown(engine, matrices).toMatchObject({ "R(q)": thirdTurn });
});

test("goes from view to view, and a drag turns the body", async ({ engine, site }) => {
  await openView(engine, `${site.url}#read?quaternion=1+0+0+0&${fromX}`, 1280);
  const hasBody = () => document.querySelector(".stage .picture-body") !== null;
  await shown(engine, hasBody).toBe(true);
  const { x, y } = await engine.evaluate(middleOf, ".stage .picture-body");
  await engine.drag({ x, y }, { x: x + 30, y }, { x: x + 60, y });
  await shown(engine, quaternion).toMatch(/^\d+(?:\.\d+)?deg about z$/);

  const go = (fragment: string) =>
    engine.evaluate((fragment) => {
      location.hash = fragment;
    }, fragment);
  const numbers = () => engine.evaluate(matrices).then((shown) => Object.values(shown));
  await go("compose?p=90deg about z&q=90deg about x");
  await expect.poll(numbers).toContain(thirdTurn);
  await go("translate?translated=0 0 0.6 0.8&from=openvins&to=eigen");
  await expect.poll(numbers).toContain("0.280000 −0.960000 0 0.960000 0.280000 0 0 0 1");
  await go("identify");
  await shown(engine, words).toContain("OpenSceneGraph");
  await go("libraries");
  await shown(engine, words).toContain("Apple CMQuaternion");
});

test("every number of every view is whole, on a phone and on a desk", async ({
  engine,
  engineName,
  site,
}) => {
  // whole_numbers.spec.ts has the other views in Chromium, and more widths.
  for (const address of engineName === "chromium" ? ["read"] : addresses) {
    await openView(engine, `${site.url}#${encodeURI(address)}`, 320);
    for (const width of [320, 390, 1280]) {
      await engine.widen(width);
      expect(await engine.evaluate(cutNumbers), `${address}, ${width} px`).toEqual([]);
    }
  }
});

test("works without a network after one visit", async ({ engine, site }) => {
  await openView(engine, site.url, 1280);
  await shown(engine, () => navigator.serviceWorker.controller?.state).toBe("activated");
  site.goAway();
  await engine.reload();
  await shown(engine, matrices).toMatchObject(aboutZ);
});
