// The consumers that need nothing beyond what the tests of quatlas have: Node, TypeScript, Vite and Chromium.
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { build } from "vite";
import { output, root } from "./project.mjs";

const STRICT = "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'";
const FETCHING = `${STRICT}; connect-src 'self'`;
const WITHOUT_WASM = "default-src 'none'; script-src 'self'; connect-src 'self'";

/** Each with what it is called, and what it has to give: "ok", or what an error has to name. */
export const here = [
  ...[
    ["import, named", "named.mjs"],
    ["import, namespace", "namespace.mjs"],
    ["require", "required.cjs"],
    ["import() in CommonJS", "imported.cjs"],
    ["one instance for both", "same_instance.mjs"],
    ["JSON tables", "tables.cjs"],
    ["quatlas/rotation, import", "rotation.mjs"],
    ["quatlas/rotation, require", "rotation.cjs"],
    ["two worker threads", "threads.mjs"],
    ...["bytes", "module", "response", "promise"].map((source) => [
      `quatlas/web, given as ${source}`,
      "web.mjs",
      source,
    ]),
  ].map(([name, file, ...args]) => ({
    name: `Node: ${name}`,
    found: ({ project }) => project.node(join("node", file), ...args),
  })),
  ...[
    ["node16", "node16"],
    ["nodenext", "nodenext"],
    ["esnext", "bundler"],
    ["preserve", "bundler"],
  ].map(([module, resolution]) => ({
    name: `TypeScript: ${module}, ${resolution}`,
    found: ({ project }) => typed(project, module, resolution),
  })),
  ...["main", "web", "start_worker"].map((page) => ({
    name: `Vite: build, ${page}`,
    found: ({ project, browser }) => builtByVite(project, browser, page),
  })),
  ...[
    ["module", "module.html"],
    ["import map", "import_map.html"],
    ["quatlas/web", "web.html"],
    ["quatlas/rotation", "rotation.html"],
    ["module worker", "worker.html?module"],
    ["classic worker", "worker.html?classic"],
    ["classic script", "classic.html"],
    ["module, strict policy", "module.html", STRICT],
    ["module worker, strict policy", "worker.html?module", STRICT],
    ["quatlas/rotation, strict policy", "rotation.html", STRICT],
    ["classic script, strict policy", "classic.html", STRICT],
    ["quatlas/web, strict policy", "web.html", FETCHING],
  ].map(([name, file, policy]) => ({
    name: `browser: ${name}`,
    found: ({ project, browser }) => browser.served(project.folder, `browser/${file}`, policy),
  })),
  {
    name: "browser: classic script from file://",
    found: ({ project, browser }) =>
      browser.titleOf(pathToFileURL(project.path("browser", "classic.html")).href),
  },
  ...["module", "classic", "web"].map((page) => ({
    name: `browser: ${page}, a policy without wasm`,
    expected: /add 'wasm-unsafe-eval' to its script-src/,
    found: ({ project, browser }) =>
      browser.served(project.folder, `browser/${page}.html`, WITHOUT_WASM),
  })),
];

async function typed(project, module, resolution) {
  const options = ["--noEmit", "--strict", "--module", module, "--moduleResolution", resolution];
  const platform = ["--types", "", "--lib", "es2023,dom", "--target", "es2022"];
  const files = ["program.mts", "program.cts", "web.mts"];
  // node16 does not know the attribute that says that a module is JSON.
  if (module !== "node16") files.push("tables.mts");
  const chosen = files.map((file) => join("typed", file));
  const json = ["--resolveJsonModule"];
  const tsc = join(root, "node_modules", "typescript", "bin", "tsc");
  await output(project.folder, process.execPath, [
    tsc,
    ...options,
    ...platform,
    ...json,
    ...chosen,
  ]);
  return "ok";
}

async function builtByVite(project, browser, page) {
  const outDir = project.path(`vite_${page}`);
  await build({
    configFile: false,
    logLevel: "silent",
    root: project.path("bundled"),
    base: "./",
    worker: { format: "es" },
    build: { outDir, rolldownOptions: { input: project.path("bundled", `${page}.html`) } },
  });
  return browser.served(outDir, `${page}.html`);
}
