// The npm package: for each entry its scripts with their wasm, and its types. The tables, and what the README links,
// are packed as they stand in the sources.
import { mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
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
  { source: "numbers/index.ts", module: "rotation", script: "quatlas_rotation" },
];

/** The entry of numbers alone. */
const NUMBERS = "numbers/index.ts";

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
async function built({ source }, format) {
  const { build } = await import("vite");
  const [{ output }] = await build({
    configFile: false,
    logLevel: "warn",
    root: sources,
    plugins: [wasmInScripts()],
    build: {
      lib: { entry: source, formats: [format], fileName: "entry" },
      // What is packed is read by programs; who reads it has the sources.
      minify: true,
      target: "es2022",
      write: false,
    },
  });
  const [{ code, exports }, ...beside] = output;
  return { code, names: exports.filter((name) => name !== "default").sort(), beside };
}

async function writeModule(entry) {
  const { module } = entry;
  const { code, beside } = await built(entry, "es");
  write(`${module}.mjs`, code);
  for (const { fileName, source: bytes } of beside) write(fileName, bytes);
}

async function writeScript(entry, version) {
  const { module, script } = entry;
  const { code, names } = await built(entry, "cjs");
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
  writeNumbersTypes(declared);
  for (const { source, module, script, typesOf } of ENTRIES) {
    if (source === NUMBERS) {
      write(`${module}.d.mts`, `export * from "./types/numbers/index.mjs";\n`);
      write(`${module}.d.cts`, `export * from "./types/numbers/index.cjs";\n`);
      continue;
    }
    const shared = typesOf === undefined ? coreTypes : `export * from "./${typesOf}.mjs";\n`;
    const own = declarations(
      join(declared, source.replace(/\.ts$/, ".d.ts")),
      typesOf !== undefined,
    );
    const text = withoutLinks(shared + own);
    write(`${module}.d.mts`, text);
    if (script === undefined) continue;
    const required = text.replaceAll('/index.mjs"', '/index.cjs"');
    write(`${module}.d.cts`, `${required}export as namespace ${script};\n`);
  }
  for (const file of readdirSync(declared, { recursive: true })) {
    if (file.endsWith(".d.ts")) rmSync(join(declared, file));
  }
}

/**
 * The types of numbers, as files that all entries share: so a `Rotation` of one is that of another for TypeScript
 * too.
 */
function writeNumbersTypes(declared) {
  const files = ["conventions", "quatlas_error"];
  for (const file of readdirSync(join(declared, "numbers"))) {
    files.push(join("numbers", file.replace(/\.d\.ts$/, "")));
  }
  for (const file of files) {
    const text = readFileSync(join(declared, `${file}.d.ts`), "utf8");
    for (const kind of ["mjs", "cjs"]) {
      const core = `${file.startsWith("numbers") ? "../" : ""}../index.${kind}`;
      const written = text
        .replace(/"(?:\.\.\/)+pkg\/quatlas\.js"/g, JSON.stringify(core))
        .replace(/(["'])(\.[^"']*)\.ts\1/g, `$1$2.${kind}$1`);
      writeFileSync(join(declared, `${file}.d.${kind.replace("js", "ts")}`), withoutLinks(written));
    }
  }
}

/** The comments come from Rust; its links lead nowhere here. */
const withoutLinks = (text) => text.replace(/\[(`[^`]+`)\](\((?:[^()\n]|\(\))*\))?/g, "$1");

/** The declarations of a source, and of those whose exports it passes on unless these are known already. */
function declarations(file, arePassedOnKnown) {
  return readFileSync(file, "utf8")
    .replace(/^import [^;]*pkg\/quatlas\.js";\n/gm, "")
    .replace(/^export \* from "\.\/numbers\/index\.ts";\n/gm, () =>
      arePassedOnKnown ? "" : 'export * from "./types/numbers/index.mjs";\n',
    )
    .replace(/^export \* from "(.*)\.ts";\n/gm, (_, name) =>
      arePassedOnKnown ? "" : declarations(join(dirname(file), `${name}.d.ts`), false),
    );
}
