// The packed package in the environments that this machine has; the others by `npm run long -- consumers`.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { startBrowser } from "./browser.mjs";
import { here } from "./here.mjs";
import { pack, unpackedProject } from "./project.mjs";

let packed;
let project;
let browser;

before(async () => {
  packed = pack();
  project = unpackedProject(packed);
  browser = await startBrowser();
});

after(async () => {
  await browser?.close();
  project?.remove();
  packed?.remove();
});

// Most of the time goes by in other programs.
describe("consumers", { concurrency: 3 }, () => {
  for (const { name, found, expected = /^ok$/ } of here) {
    test(name, async () => assert.match(await found({ project, browser }), expected));
  }
});
