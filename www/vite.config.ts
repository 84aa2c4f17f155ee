import { defineConfig, type Plugin } from "vite";
import { home } from "./tasks/home.ts";
import { pageLicences } from "./tasks/page_licences.ts";
import { precache } from "./tasks/precache.ts";
import { prerender } from "./tasks/prerender.ts";

export default defineConfig({
  root: import.meta.dirname,
  // Relative, so that the page can be served from any folder.
  base: "./",
  plugins: [withoutPolicy(), home(), pageLicences(), prerender(() => [home()]), precache()],
  build: {
    outDir: "../dist/page",
    emptyOutDir: true,
    target: "es2023",
    // Files stay files: a font or the wasm inside the script would be read before they are needed.
    assetsInlineLimit: 0,
    // A browser that preloads no modules by itself loads them a moment later.
    modulePreload: { polyfill: false },
    rolldownOptions: {
      // The page is rendered in the build.
      checks: { pluginTimings: false },
      output: {
        codeSplitting: {
          groups: [
            // Shared by all: a file of its own, with a name that stays.
            { name: "preact", test: /node_modules\/@?preact/, priority: 1 },
            // What the first view needs, in one file, also where a later one shares it.
            { name: "read", tags: ["$initial"] },
          ],
        },
      },
    },
  },
  preview: { port: 4173 },
});

/** The development server puts styles into the page, which the policy of the page forbids. */
function withoutPolicy(): Plugin {
  return {
    name: "quatlas:without-policy",
    apply: "serve",
    transformIndexHtml: (html) =>
      html.replace(/<meta\s+http-equiv="Content-Security-Policy"[^>]*>/, ""),
  };
}
