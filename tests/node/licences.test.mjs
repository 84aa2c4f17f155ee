// What is shipped carries the licences and notices of what is in it. The lists are made here in another
// way than in the build: by cargo tree, by what the sources import, and by what the built page holds.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { build } from "vite";

const root = fileURLToPath(new URL("../..", import.meta.url));
const inRoot = (...path) => readFileSync(join(root, ...path), "utf8");
/** Without what line ends and margins do to a text. */
const plain = (text) => text.replace(/\s+/g, " ").trim();

let page;
before(async () => {
  // In memory: what is in dist may be of an earlier commit.
  const built = await build({
    configFile: join(root, "www/vite.config.ts"),
    logLevel: "warn",
    build: { write: false },
  });
  page = built.output;
});
const ofPage = () => page.find(({ fileName }) => fileName === "licences.txt").source;
const ofPackage = () => inRoot("dist/npm/THIRD_PARTY.txt");

function cratesOfTree() {
  const tree = execFileSync(
    "cargo",
    [
      ...["tree", "--locked", "--target", "wasm32-unknown-unknown"],
      ...["--edges", "normal,no-proc-macro", "--prefix", "none", "--format", "{p}"],
    ],
    { cwd: root, encoding: "utf8" },
  );
  const crates = tree.split("\n").map((line) => line.match(/^(\S+) v(\S+)/));
  const names = crates.filter(Boolean).map(([, name, version]) => `${name} ${version}`);
  return [...new Set(names)].filter((name) => !name.startsWith("quatlas "));
}

test("every crate of the wasm is named, in the package and beside the page", () => {
  const crates = cratesOfTree();
  assert.ok(crates.length > 20, `${crates.length}`);
  for (const known of ["twofloat", "libm", "winnow", "nalgebra", "serde", "wasm-bindgen"]) {
    assert.ok(
      crates.some((crate) => crate.startsWith(`${known} `)),
      known,
    );
  }
  for (const crate of crates) {
    for (const text of [ofPackage(), ofPage()]) assert.ok(text.includes(`\n${crate} (`), crate);
  }
  for (const text of [ofPackage(), ofPage()]) assert.match(text, /Rust standard library/);
});

/** What the sources of the page and what they import ask node_modules for; what renders it at build is not in it. */
function packagesOfPage() {
  const sources = readdirSync(join(root, "www"), { recursive: true })
    .map((file) => file.replaceAll("\\", "/"))
    .filter(
      (file) =>
        /\.(tsx?|css|html)$/.test(file) && !/^(tasks|package|prerender)\b|config/.test(file),
    )
    .map((file) => inRoot("www", file));
  const asked = sources.flatMap((source) =>
    [...source.matchAll(/(?:from |node_modules\/)["']?(@[\w-]+\/[\w-]+|[a-z][\w-]*)/g)].map(
      ([, name]) => name,
    ),
  );
  const found = new Set();
  const waiting = asked.filter((name) => existsSync(join(root, "node_modules", name)));
  for (let name = waiting.pop(); name !== undefined; name = waiting.pop()) {
    found.add(name);
    const { dependencies = {} } = JSON.parse(inRoot("node_modules", name, "package.json"));
    waiting.push(...Object.keys(dependencies).filter((other) => !found.has(other)));
  }
  return [...found].sort();
}

test("every package and font of the page has its licence text beside it", () => {
  const packages = packagesOfPage();
  for (const known of ["preact", "@preact/signals", "@preact/signals-core"]) {
    assert.ok(packages.includes(known), known);
  }
  const text = plain(ofPage());
  for (const name of packages) {
    const { version } = JSON.parse(inRoot("node_modules", name, "package.json"));
    assert.ok(text.includes(`${name} ${version} (`), name);
    assert.ok(text.includes(plain(inRoot("node_modules", name, "LICENSE"))), name);
  }
  const fonts = page.map(({ fileName }) => fileName).filter((name) => name.endsWith(".woff2"));
  assert.ok(fonts.length >= 4, `${fonts}`);
  for (const font of fonts) {
    const [family] = font.match(/ibm-plex-[a-z]+/) ?? [];
    assert.ok(text.includes(`@fontsource/${family} `), font);
  }
  assert.match(text, /SIL OPEN FONT LICENSE Version 1\.1/);
});

test("the conditions are those of the licences: notices, and whole texts", () => {
  for (const text of [ofPackage(), ofPage()].map(plain)) {
    // BSD-3-Clause of twofloat, Apache-2.0 of nalgebra, MIT of winnow.
    assert.match(text, /Redistributions in binary form must reproduce/);
    assert.match(text, /Apache License Version 2\.0, January 2004.*END OF TERMS AND CONDITIONS/);
    assert.match(text, /Permission is hereby granted, free of charge/);
    assert.doesNotMatch(text, /undefined|null \(|\[object/);
  }
  const text = plain(ofPage());
  for (const own of ["LICENSE-MIT", "LICENSE-APACHE"]) assert.ok(text.includes(plain(inRoot(own))));
});

test("no path of the machine is in the texts", () => {
  for (const text of [ofPackage(), ofPage()]) assert.ok(!text.includes(root));
});
