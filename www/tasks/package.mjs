// The npm package: one CommonJS file that holds the optimised wasm, an ES module in front of it,
// and the types.
import { copyFileSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { cratesInWasm, licencesText } from "./licences.mjs";
import { ask, root, Stop, say } from "./shell.mjs";

export async function buildPackage() {
  say("building the npm package");
  const { build } = await import("vite");
  const out = join(root, "dist", "npm");
  rmSync(out, { recursive: true, force: true });
  await build({
    configFile: false,
    logLevel: "warn",
    root: join(root, "www", "package"),
    build: {
      lib: { entry: "index.ts", formats: ["cjs"], fileName: () => "index.cjs" },
      outDir: out,
      emptyOutDir: true,
      minify: false,
      target: "node20",
    },
  });
  // One instance serves both: the ES module only passes on what the CommonJS file made.
  const names = Object.keys((await import(`${out}/index.cjs`)).default).sort();
  const esModule = [
    'import quatlas from "./index.cjs";',
    `export const { ${names.join(", ")} } = quatlas;`,
  ];
  writeFileSync(join(out, "index.mjs"), `${esModule.join("\n")}\n`);
  writeTypes(out);
  // The glue of wasm-bindgen is of the crate of that name.
  const title = "What is compiled into quatlas: licences and notices.";
  writeFileSync(join(out, "THIRD_PARTY.txt"), licencesText(title, cratesInWasm()));
  for (const name of ["libraries.json", "observations.json"]) {
    copyFileSync(join(root, "src", "library", name), join(out, name));
  }
}

/** The types that the core generates, and the declarations of what index.ts exports. */
function writeTypes(out) {
  const emitted = ask("tsc", "-p", "www/package", "--declarationDir", out);
  if (emitted === undefined) throw new Stop("the types of the package could not be made");
  const core = readFileSync(join(root, "pkg", "quatlas.d.ts"), "utf8");
  // The comments come from Rust; its links lead nowhere here.
  const withoutLinks = (text) => text.replace(/\[(`[^`]+`)\](\((?:[^()\n]|\(\))*\))?/g, "$1");
  const coreTypes = core.slice(0, core.search(/\/\*\*(?:(?!\*\/)[\s\S])*\*\/\s*export function/));
  const index = readFileSync(join(out, "index.d.ts"), "utf8").replace(
    /^.*pkg\/quatlas\.js.*\n/gm,
    "",
  );
  for (const extension of ["d.mts", "d.cts"]) {
    writeFileSync(join(out, `index.${extension}`), withoutLinks(coreTypes) + index);
  }
  for (const emitted of ["index.d.ts", "answering.d.ts"]) rmSync(join(out, emitted));
}
