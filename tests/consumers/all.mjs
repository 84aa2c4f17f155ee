// node tests/consumers/all.mjs [word]: the packed package in every environment that is known, or in those whose name
// has the word, and the table of them.
import { startBrowser } from "./browser.mjs";
import { elsewhere } from "./elsewhere.mjs";
import { here } from "./here.mjs";
import { installedProject, pack, unpackedProject } from "./project.mjs";

const [, , word = ""] = process.argv;

/** How much of what a program says is shown of a failure. */
const SHOWN = 300;

const packed = pack();
const browser = await startBrowser();
const rows = [];

for (const { packages, consumers } of [{ packages: [], consumers: here }, ...elsewhere]) {
  const asked = consumers.filter(({ name }) => name.toLowerCase().includes(word.toLowerCase()));
  if (asked.length === 0) continue;
  // What cannot be installed fails in each of its rows.
  const project = projectWith(packages);
  for (const consumer of asked) tell(consumer.name, await answered(consumer, project));
  const made = await project.catch(() => undefined);
  made?.remove();
}
await browser.close();
packed.remove();

const failed = rows.filter(({ why }) => why !== "ok").length;
console.log(`consumers: ${rows.length - failed} passed, ${failed} failed`);
process.exitCode = failed === 0 ? 0 : 1;

async function projectWith(packages) {
  return packages.length === 0 ? unpackedProject(packed) : installedProject(packed, packages);
}

/** "ok", or why not. */
async function answered({ found, expected = /^ok$/ }, project) {
  try {
    const answer = await found({ project: await project, browser, packed });
    return expected.test(answer) ? "ok" : answer;
  } catch (error) {
    return error.message;
  }
}

function tell(name, why) {
  rows.push({ name, why });
  console.log(`| ${name} | ${why.replaceAll(/\s+/g, " ").slice(0, SHOWN)} |`);
}
