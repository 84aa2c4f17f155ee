// The rooms of the page, and which may use which: imports point down, and no two files need each other.
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path/posix";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { parseSync } from "vite";

const page = fileURLToPath(new URL("../../www", import.meta.url));

/** What every room above the model may use. */
const ground = ["engine.ts", "values.ts", "model"];
const parts = [
  ...ground,
  ...["dom", "number", "address", "state", "words", "action", "copy", "picture"],
  "view/parts",
];

/**
 * The rooms from the bottom up, each with the rooms that it may use beside itself. A type counts as much
 * as a value. `view/*` is the folder of each view; some rooms of this table wait for what comes.
 */
const mayUse = {
  package: [],
  "engine.ts": ["package"],
  // The core's names and conventions as constants: what reads an address has no core yet.
  "values.ts": [],
  dom: [],
  model: ["engine.ts", "values.ts"],
  number: ground,
  address: ground,
  // Waits: tables of attitudes out of files and into them.
  file: [...ground, "number"],
  // Waits: work beside the page, for what takes long.
  worker: [...ground, "file"],
  state: [...ground, "address"],
  // Sentences hold numbers.
  words: [...ground, "number"],
  action: [...ground, "dom", "number", "state", "words"],
  copy: [...ground, "number", "address", "words"],
  picture: [...ground, "dom", "number", "state", "words"],
  "view/parts": parts,
  // Read, Compose, Translate, Libraries, Identify; a view that comes is a folder beside them.
  "view/*": [...parts, "file", "worker"],
  "view/frame": [...parts, "view/*"],
  "main.ts": [...parts, "view/frame", "style.css"],
  // The page as HTML, at build.
  "prerender.tsx": [...ground, "state", "view/frame"],
  "first.js": [],
  // It imports none: it has Vite load them.
  tasks: [],
  "service_worker.js": [],
  "vite.config.ts": ["tasks"],
};

/** The rooms that may name the built core. */
const nextToCore = ["engine.ts", "values.ts", "package"];

/** The room of a file: its folder, that of a view, or its own name where it stands in none. */
function roomOf(file) {
  const [folder, inner, ...below] = file.split("/");
  if (folder !== "view" || below.length === 0) return folder;
  return ["parts", "frame"].includes(inner) ? `view/${inner}` : "view/*";
}

/** The folder of each view is a room of its own: two views do not use each other. */
const viewOf = (file) => (roomOf(file) === "view/*" ? file.split("/")[1] : undefined);
const isSameRoom = (one, other) => roomOf(one) === roomOf(other) && viewOf(one) === viewOf(other);

/** The text of every script of the page, by its path below www. */
const sources = new Map(
  readdirSync(page, { recursive: true })
    .map((name) => name.replaceAll("\\", "/"))
    .filter((name) => /\.[mc]?[jt]sx?$/.test(name) && !name.startsWith("public/"))
    .map((file) => [file, readFileSync(`${page}/${file}`, "utf8")]),
);

/** What a script names of others, with the line: values, types, styles, and what is loaded later. */
function usesOf(file, source) {
  const { module, errors } = parseSync(file, source, { lang: "tsx" });
  assert.deepEqual(errors, [], file);
  const { staticImports, staticExports, dynamicImports } = module;
  const named = [
    ...staticImports.map(({ moduleRequest: { value, start } }) => ({ value, start })),
    ...staticExports
      .flatMap(({ entries }) => entries)
      .filter(({ moduleRequest }) => moduleRequest)
      .map(({ moduleRequest: { value, start } }) => ({ value, start })),
    ...dynamicImports.map(({ moduleRequest: { start, end } }) => ({
      value: source.slice(start + 1, end - 1),
      start,
    })),
  ];
  return named
    .filter(({ value }) => value.startsWith("."))
    .map(({ value, start }) => ({
      to: join(dirname(file), value.replace(/\?.*$/, "")),
      line: source.slice(0, start).split("\n").length,
    }));
}

/** What is wrong with the imports of a script, as `file:line: why`. */
function wrongUses(file, source) {
  const allowed = mayUse[roomOf(file)];
  if (allowed === undefined) return [`${file}:1: stands in no room of the table`];
  return usesOf(file, source).flatMap(({ to, line }) => {
    const at = `${file}:${line}`;
    if (to.startsWith("../pkg/")) {
      return nextToCore.includes(roomOf(file))
        ? []
        : [`${at}: names the core, as only its door may`];
    }
    // package.json, and what the core is made of.
    if (to.startsWith("../") || isSameRoom(file, to)) return [];
    const room = roomOf(to);
    return allowed.includes(room) ? [] : [`${at}: ${roomOf(file)} may not use ${room} (${to})`];
  });
}

/** A way of imports from a script back to itself, as the files on it; nothing where there is none. */
function circleIn(uses) {
  const done = new Set();
  const way = [];
  const from = (file) => {
    if (way.includes(file)) return [...way.slice(way.indexOf(file)), file];
    if (done.has(file)) return undefined;
    way.push(file);
    for (const { to } of uses.get(file) ?? []) {
      const found = from(to);
      if (found) return found;
    }
    way.pop();
    done.add(file);
    return undefined;
  };
  for (const file of uses.keys()) {
    const found = from(file);
    if (found) return found;
  }
  return undefined;
}

test("every room of the page uses only rooms below it", () => {
  assert.ok(sources.size > 150, `${sources.size} files`);
  const found = [...sources].flatMap(([file, source]) => wrongUses(file, source));
  assert.deepEqual(found, []);
});

test("no two files of the page need each other", () => {
  const uses = new Map([...sources].map(([file, source]) => [file, usesOf(file, source)]));
  const circle = circleIn(uses);
  const lines = circle?.slice(1).map((to, at) => {
    const from = circle[at];
    return `${from}:${uses.get(from)?.find((use) => use.to === to)?.line} uses ${to}`;
  });
  assert.deepEqual(lines ?? [], []);
});

test("a use against the direction is found with its line, of whatever kind it is", () => {
  const wrong = [
    ["words/a.ts", 'import { a } from "../view/parts/Ask.tsx";'],
    ["words/a.ts", 'import type { A } from "../copy/values.ts";'],
    ["model/a.ts", 'export * from "../state/store.ts";'],
    ["model/a.ts", 'export type { A } from "../words/undo.ts";'],
    ["state/a.ts", 'const a = () => import("../view/frame/Page.tsx");'],
    ["view/read/a.ts", 'import { a } from "../compose/Compose.tsx";'],
    ["view/parts/a.ts", 'import { a } from "../read/Read.tsx";'],
    ["view/read/a.ts", 'import "../identify/answer.css";'],
    ["view/read/a.ts", 'import { analyze } from "../../../pkg/quatlas.js";'],
    ["model/a.ts", 'import type { Request } from "../../pkg/quatlas.js";'],
    ["cellar/a.ts", ""],
    ["view/a.ts", ""],
  ];
  for (const [file, source] of wrong) {
    const line = source === "" ? 1 : 2;
    const [found, ...more] = wrongUses(file, `// Why.\n${source}`);
    assert.match(found ?? "", new RegExp(`^${file}:${line}: `), source);
    assert.deepEqual(more, [], source);
  }
  const right = [
    ["words/identify/a.ts", 'import type { A } from "../../model/probes.ts";'],
    ["words/a.ts", 'import { shown } from "../number/format.ts";'],
    ["view/trajectory/a.ts", 'import { a } from "../../file/table.ts";'],
    ["view/frame/a.ts", 'const a = () => import("../trajectory/Trajectory.tsx");'],
    ["engine.ts", 'import * as small from "../pkg/small/quatlas_small.js";'],
  ];
  for (const [file, source] of right) assert.deepEqual(wrongUses(file, source), [], source);
});

test("a circle is found, also of types and of what is loaded later", () => {
  const files = {
    "view/a.ts": 'import type { B } from "./b.ts";',
    "view/b.ts": 'export * from "./c.ts";',
    "view/c.ts": 'const a = () => import("./a.ts");',
    "view/d.ts": 'import { A } from "./a.ts";',
  };
  const circle = (names) =>
    circleIn(new Map(names.map((name) => [name, usesOf(name, files[name])])));
  assert.deepEqual(circle(Object.keys(files)), [
    "view/a.ts",
    "view/b.ts",
    "view/c.ts",
    "view/a.ts",
  ]);
  assert.equal(circle(["view/a.ts", "view/b.ts", "view/d.ts"]), undefined);
});
