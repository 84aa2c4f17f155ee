import { defineConfig } from "vite";

export default defineConfig({
  root: import.meta.dirname,
  // Relative, so that the page can be served from any folder.
  base: "./",
  build: {
    outDir: "../dist/page",
    emptyOutDir: true,
    target: "es2023",
    // Files stay files: a font or the wasm inside the script would be read before they are needed.
    assetsInlineLimit: 0,
    rolldownOptions: {
      output: {
        // Shared by all: a file of its own, with a name that stays.
        codeSplitting: { groups: [{ name: "preact", test: /node_modules\/@?preact/ }] },
      },
    },
  },
  preview: { port: 4173 },
});
