import { defineConfig } from "@playwright/test";

const executablePath = process.env["QUATLAS_BROWSER"];
const port = Number(process.env["QUATLAS_PORT"] ?? 4187);

export default defineConfig({
  testDir: ".",
  outputDir: "results",
  fullyParallel: true,
  forbidOnly: true,
  workers: 2,
  reporter: "list",
  use: {
    baseURL: `http://localhost:${port}/`,
    browserName: "chromium",
    // Every test but those of offline.spec.ts is answered by the server.
    serviceWorkers: "block",
    launchOptions: {
      ...(executablePath ? { executablePath } : {}),
      // A browser that looks nothing up by itself, so that every request is the page's own.
      args: [
        "--no-sandbox",
        "--disable-background-networking",
        "--disable-component-update",
        "--disable-sync",
        "--no-first-run",
      ],
    },
  },
  webServer: {
    command: `vite preview --config www/vite.config.ts --port ${port} --strictPort`,
    cwd: "../..",
    url: `http://localhost:${port}/`,
    reuseExistingServer: false,
  },
});
