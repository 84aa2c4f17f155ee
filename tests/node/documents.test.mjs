// What the documents beside the code name is there.
import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";

const root = fileURLToPath(new URL("../..", import.meta.url));
const documents = ["README.md", "CONTRIBUTING.md", "bench/README.md", "tests/vectors/README.md"];

/** The links of a document to other files, without what is code. */
function linksOf(text) {
  const prose = text.replace(/```.*?```/gs, "").replace(/`[^`\n]*`(?!\])/g, "");
  return [...prose.matchAll(/\]\(([^)\s]+)\)/g)]
    .map(([, target]) => target)
    .filter((target) => !/^https?:/.test(target));
}

test("every link of a document leads to a file", () => {
  const links = documents.flatMap((document) =>
    linksOf(readFileSync(join(root, document), "utf8")).map((target) => ({ document, target })),
  );
  assert.ok(links.length > 12, `${links.length} links`);
  const broken = links.filter(
    ({ document, target }) => !existsSync(join(root, dirname(document), target)),
  );
  assert.deepEqual(broken, []);
});

test("the README has no pictures, which a registry would look for beside itself", () => {
  assert.doesNotMatch(readFileSync(join(root, "README.md"), "utf8"), /!\[/);
});

test("every test that tests/reach.md names is there", () => {
  const named = [...readFileSync(join(root, "tests/reach.md"), "utf8").matchAll(/`([^`]+)`/g)]
    .map(([, name]) => name)
    .filter((name) => name.includes(" › ") || /^\w+(::\w+){2,}$/.test(name));
  assert.ok(named.length > 120, `${named.length} tests`);
  const missing = named.filter((name) => {
    const [file, title] = name.split(" › ");
    const path = file.split("::");
    const source = title ? file : `tests/${path.slice(0, -1).join("/")}.rs`;
    const head = title === undefined ? `\nfn ${path.at(-1)}() {` : `test("${title}`;
    const isThere = [source, source.replace(/\.rs$/, "/mod.rs")].some(
      (place) =>
        existsSync(join(root, place)) && readFileSync(join(root, place), "utf8").includes(head),
    );
    return !isThere;
  });
  assert.deepEqual(missing, []);
});
