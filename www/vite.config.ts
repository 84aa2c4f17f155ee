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
  },
  preview: { port: 4173 },
});
