// The consumers that come from the registry: runtimes, bundlers, test runners and judges of packages.
import { cpSync, mkdirSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { basename, join } from "node:path";
import { createServer } from "vite";
import { output } from "./project.mjs";

const bundled = (name) => join("bundled", name);

/** Groups of consumers that are installed together; each consumer as in here.mjs. */
export const elsewhere = [
  {
    packages: ["deno@2"],
    consumers: [
      ...["named.mjs", "namespace.mjs", "required.cjs", "threads.mjs"].map((file) => ({
        name: `Deno: ${file}`,
        found: ({ project }) =>
          project.tool("deno", "run", "--node-modules-dir=manual", "--allow-all", `node/${file}`),
      })),
      {
        name: "Deno: without permissions",
        found: ({ project }) =>
          project.tool("deno", "run", "--node-modules-dir=manual", "--no-prompt", "node/named.mjs"),
      },
    ],
  },
  {
    packages: ["bun@1"],
    consumers: [
      ...["named.mjs", "namespace.mjs", "required.cjs", "threads.mjs"].map((file) => ({
        name: `Bun: ${file}`,
        found: ({ project }) => project.tool("bun", join("node", file)),
      })),
      {
        name: "Bun: build for a browser",
        found: async ({ project, browser }) => {
          const out = outFor(project, "module.html");
          await project.tool("bun", "build", bundled("main.mjs"), "--outfile", join(out, "out.js"));
          return browser.served(out, "module.html");
        },
      },
      {
        name: "Bun: build for Node",
        found: async ({ project }) => {
          const out = join(outFor(project), "out.mjs");
          await project.tool("bun", "build", "node/named.mjs", "--target=node", "--outfile", out);
          return runAlone(out);
        },
      },
    ],
  },
  {
    packages: ["esbuild@0.28"],
    consumers: [
      ...[
        ["esm", "module.html"],
        ["iife", "script.html"],
      ].map(([format, page]) => ({
        name: `esbuild: browser, ${format}`,
        found: async ({ project, browser }) => {
          const out = outFor(project, page);
          await esbuild(project, bundled("main.mjs"), join(out, "out.js"), `--format=${format}`);
          return browser.served(out, page);
        },
      })),
      {
        name: "esbuild: quatlas/web, its file copied",
        found: async ({ project, browser }) => {
          const out = outFor(project, "module.html");
          await esbuild(project, bundled("web.mjs"), join(out, "out.js"), "--format=esm");
          cpSync(project.path(WASM), join(out, basename(WASM)));
          return browser.served(out, "module.html");
        },
      },
      ...[
        ["cjs", "out.cjs", "named.mjs"],
        ["esm", "out.mjs", "named.mjs"],
        ["cjs", "out.cjs", "required.cjs"],
      ].map(([format, file, source]) => ({
        name: `esbuild: for Node, ${format} of ${source}`,
        found: async ({ project }) => {
          const out = join(outFor(project), file);
          const options = ["--platform=node", `--format=${format}`];
          await esbuild(project, join("node", source), out, ...options);
          return runAlone(out);
        },
      })),
    ],
  },
  {
    packages: ["webpack@5", "webpack-cli@6"],
    consumers: [
      ...[
        ["production", "main"],
        ["development", "main"],
        ["production", "web"],
        ["production", "start_worker"],
      ].map(([mode, entry]) => ({
        name: `webpack: ${mode}, ${entry}`,
        found: async ({ project, browser }) => {
          const out = outFor(project, "script.html");
          await webpack(project, bundled(`${entry}.mjs`), out, "--mode", mode);
          return browser.served(out, "script.html");
        },
      })),
      {
        name: "webpack: for Node",
        found: async ({ project }) => {
          const out = outFor(project);
          await webpack(project, "node/named.mjs", out, "--mode", "production", "--target", "node");
          return runAlone(join(out, "out.js"));
        },
      },
    ],
  },
  {
    packages: ["rollup@4", "@rollup/plugin-node-resolve@16", "@rollup/plugin-commonjs@29"],
    consumers: [
      ...[["node-resolve"], ["node-resolve", "commonjs"]].flatMap((plugins) => [
        ...[
          ["es", "module.html"],
          ["iife", "script.html"],
        ].map(([format, page]) => ({
          name: `Rollup with ${plugins.join(" and ")}: ${format}`,
          found: async ({ project, browser }) => {
            const out = outFor(project, page);
            await rollup(project, plugins, bundled("main.mjs"), format, join(out, "out.js"));
            return browser.served(out, page);
          },
        })),
        ...[
          ["es", "out.mjs"],
          ["cjs", "out.cjs"],
        ].map(([format, file]) => ({
          name: `Rollup with ${plugins.join(" and ")}: ${format} for Node`,
          found: async ({ project }) => {
            const out = join(outFor(project), file);
            await rollup(project, plugins, join("node", "named.mjs"), format, out);
            return runAlone(out);
          },
        })),
        {
          name: `Rollup with ${plugins.join(" and ")}: a CommonJS library with exports of its own`,
          found: async ({ project }) => {
            const out = join(outFor(project), "out.cjs");
            await rollup(project, plugins, bundled("library.mjs"), "cjs", out);
            return project.node("-p", `require(${JSON.stringify(out)}).read()`);
          },
        },
      ]),
    ],
  },
  {
    packages: ["jest@30", "jest-environment-jsdom@30"],
    consumers: ["node", "jsdom"].map((environment) => ({
      name: `Jest: ${environment}`,
      found: async ({ project }) => {
        const options = ["--rootDir", "jest", "--testMatch", "**/*.spec.cjs"];
        await project.tool("jest", ...options, `--env=${environment}`);
        return "ok";
      },
    })),
  },
  {
    packages: ["vitest@4", "jsdom@27", "happy-dom@20"],
    consumers: ["node", "jsdom", "happy-dom"].map((environment) => ({
      name: `Vitest: ${environment}`,
      found: async ({ project }) => {
        await project.tool("vitest", "run", "--dir", "vitest", `--environment=${environment}`);
        return "ok";
      },
    })),
  },
  {
    packages: [],
    consumers: [
      ...["main", "web", "start_worker"].map((page) => [page, page, {}]),
      ["main, optimizeDeps off", "main", { exclude: ["quatlas"] }],
    ].map(([name, page, optimizeDeps]) => ({
      name: `Vite: dev, ${name}`,
      found: ({ project, browser }) => servedByVite(project, browser, page, optimizeDeps),
    })),
  },
  {
    packages: ["publint@0.3"],
    consumers: [
      {
        name: "publint --strict",
        expected: /All good!/,
        found: ({ project }) => project.tool("publint", "--strict", "node_modules/quatlas"),
      },
    ],
  },
  {
    packages: ["@arethetypeswrong/cli@0.18"],
    consumers: [
      {
        // A node10 has no entries beside the first; to CommonJS quatlas/web is an ES module; a wasm has no types.
        name: "attw",
        found: async ({ project, packed }) => {
          const allowed = ["--profile", "node16", "--ignore-rules", "cjs-resolves-to-esm"];
          const untyped = ["--exclude-entrypoints", "quatlas_bg.wasm"];
          await project.tool("attw", packed.tarball, ...allowed, ...untyped);
          return "ok";
        },
      },
    ],
  },
];

const WASM = "node_modules/quatlas/dist/npm/quatlas_bg.wasm";

/** A new folder for what is built, with a page that loads `out.js`. */
function outFor(project, page) {
  const out = mkdtempSync(project.path("built-"));
  if (page !== undefined) cpSync(project.path("bundled", page), join(out, page));
  return out;
}

/** What a built script prints where no package is installed. */
async function runAlone(script) {
  const folder = mkdtempSync(join(tmpdir(), "quatlas-alone-"));
  const file = join(folder, basename(script));
  mkdirSync(folder, { recursive: true });
  cpSync(script, file);
  try {
    return await output(folder, process.execPath, [file]);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

const esbuild = (project, entry, out, ...options) =>
  project.tool("esbuild", entry, "--bundle", "--log-level=error", `--outfile=${out}`, ...options);

const webpack = (project, entry, out, ...options) =>
  project.tool("webpack", `./${entry}`, "-o", out, "--output-filename", "out.js", ...options);

function rollup(project, plugins, entry, format, out) {
  const used = plugins.flatMap((name) => ["--plugin", `@rollup/plugin-${name}`]);
  const strict = ["--failAfterWarnings", "--external", "node:module"];
  return project.tool("rollup", entry, ...used, "--format", format, "--file", out, ...strict);
}

async function servedByVite(project, browser, page, optimizeDeps) {
  const server = await createServer({
    configFile: false,
    logLevel: "silent",
    root: project.path("bundled"),
    cacheDir: mkdtempSync(project.path("cache-")),
    optimizeDeps,
    server: { port: 0, host: "127.0.0.1", fs: { strict: false } },
  });
  await server.listen();
  try {
    return await browser.titleOf(
      `http://127.0.0.1:${server.httpServer.address().port}/${page}.html`,
    );
  } finally {
    await server.close();
  }
}
