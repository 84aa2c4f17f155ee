// The npm package: for each entry its scripts with their wasm, and its types. The tables, and what the README links,
// are packed as they stand in the sources.
import { mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { cratesInWasm, licencesText, nodePackage } from "./licences.mjs";
import { ask, root, Stop, say } from "./shell.mjs";
import { wasmInScripts } from "./wasm_in_scripts.mjs";

const out = join(root, "dist", "npm");
const sources = join(root, "www", "package");

/**
 * The entries: the source of each, and the ES module that it becomes. With a `script` that is the file which
 * holds everything, for `require` and for a classic script, where it is the global of that name; the ES
 * module passes on what it made; there is another one for Node. Without one the ES module itself holds it.
 */
const ENTRIES = [
  { source: "index.ts", module: "index", script: "quatlas" },
  { source: "web.ts", module: "web", typesOf: "index" },
];

export async function buildPackage() {
  say("building the npm package");
  rmSync(out, { recursive: true, force: true });
  mkdirSync(out, { recursive: true });
  const { version } = JSON.parse(readFileSync(join(root, "package.json"), "utf8"));
  for (const entry of ENTRIES) {
    if (entry.script === undefined) await writeModule(entry);
    else await writeScript(entry, version);
  }
  // Here .js is CommonJS, and webpack looks for what has effects in the package.json that is nearest.
  const { sideEffects } = JSON.parse(readFileSync(join(root, "package.json"), "utf8"));
  const nearest = {
    type: "commonjs",
    sideEffects: sideEffects.map((file) => file.replace("./dist/npm", ".")),
  };
  write("package.json", `${JSON.stringify(nearest, null, 2)}\n`);
  writeTypes();
  // The glue of wasm-bindgen is of the crate of that name.
  const title = "What is compiled into quatlas: licences and notices.";
  const parts = [...cratesInWasm(), nodePackage("fflate")];
  write("THIRD_PARTY.txt", licencesText(title, parts));
}

const write = (file, text) => writeFileSync(join(out, file), text);

/** The entry as one script, and the files beside it. */
async function built(source, format) {
  const { build } = await import("vite");
  const [{ output }] = await build({
    configFile: false,
    logLevel: "warn",
    root: sources,
    plugins: [wasmInScripts()],
    build: {
      lib: { entry: source, formats: [format], fileName: "entry" },
      minify: false,
      target: "es2022",
      write: false,
    },
  });
  const [{ code, exports }, ...beside] = output;
  return { code, names: exports.filter((name) => name !== "default").sort(), beside };
}

async function writeModule({ source, module }) {
  const { code, beside } = await built(source, "es");
  write(`${module}.mjs`, code);
  for (const { fileName, source: bytes } of beside) write(fileName, bytes);
}

async function writeScript({ source, module, script }, version) {
  const { code, names } = await built(source, "cjs");
  const key = `Symbol.for(${JSON.stringify(`${script}@${version}`)})`;
  write(
    `${script}.js`,
    inAscii(`// ${script} ${version}: for require, for a <script>, and behind ${module}.mjs.
(function (scope) {
  const key = ${key};
  function make(exports) {
"use strict";
${code}
    return exports;
  }
  // Hidden there for ${module}.mjs, which bundlers and browsers may read beside this file as an ES module too.
  if (!(key in globalThis)) Object.defineProperty(globalThis, key, { value: make({}) });
  const made = globalThis[key];
  // Not in place of the exports that there are: they may be those of a bundle around this file.
  if (typeof exports === "object" && typeof module === "object") Object.assign(exports, made);
  else if (scope !== undefined) scope.${script} = made;
})((function () { return this; })());
`),
  );
  const passOn = (from) => `import "./${from}";

export const {
${names.map((name) => `  ${name},\n`).join("")}} = globalThis[${key}];
`;
  write(`${module}.mjs`, passOn(`${script}.js`));
  // Node looks through what an ES module imports for its exports: in a file of this size longer than all else takes.
  write(`${module}.node.mjs`, passOn(`${script}.node.cjs`));
  write(`${script}.node.cjs`, `require("./${script}.js");\n`);
}

/** A page that says no encoding, such as one that is opened as a file, reads its scripts in another one. */
const inAscii = (code) =>
  code.replace(/[^\0-\x7f]/g, (unit) => `\\u${unit.charCodeAt(0).toString(16).padStart(4, "0")}`);

/** The types that the core generates, and the declarations of what the entries export. */
function writeTypes() {
  const declared = join(out, "types");
  if (ask("tsc", "-p", "www/package", "--declarationDir", declared) === undefined) {
    throw new Stop("the types of the package could not be made");
  }
  const core = readFileSync(join(root, "pkg", "quatlas.d.ts"), "utf8");
  const coreTypes = core.slice(0, core.search(/\/\*\*(?:(?!\*\/)[\s\S])*\*\/\s*export function/));
  for (const { source, module, script, typesOf } of ENTRIES) {
    const shared = typesOf === undefined ? coreTypes : `export * from "./${typesOf}.mjs";\n`;
    const own = declarations(
      join(declared, source.replace(/\.ts$/, ".d.ts")),
      typesOf !== undefined,
    );
    const text = withoutLinks(shared + own);
    write(`${module}.d.mts`, text);
    if (script !== undefined) write(`${module}.d.cts`, `${text}export as namespace ${script};\n`);
  }
  rmSync(declared, { recursive: true });
}

/** The comments come from Rust; its links lead nowhere here. */
const withoutLinks = (text) => text.replace(/\[(`[^`]+`)\](\((?:[^()\n]|\(\))*\))?/g, "$1");

/** The declarations of a source, and of those whose exports it passes on unless these are known already. */
function declarations(file, arePassedOnKnown) {
  return readFileSync(file, "utf8")
    .replace(/^import [^;]*pkg\/quatlas\.js";\n/gm, "")
    .replace(/^export \* from "(.*)\.ts";\n/gm, (_, name) =>
      arePassedOnKnown ? "" : declarations(join(dirname(file), `${name}.d.ts`), false),
    );
}
