import { defineConfig } from "@playwright/test";
import type { EngineName } from "./engines/engine.ts";

const executablePath = process.env["QUATLAS_BROWSER"];
const port = Number(process.env["QUATLAS_PORT"] ?? 4187);

/** What matters most; all other tests are Chromium's. */
const inEveryEngine = "engines.spec.ts";
const ofFirefox = "firefox.spec.ts";
const isThere = (variable: string) => Boolean(process.env[variable]);

export default defineConfig<object, { engineName: EngineName }>({
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
  projects: [
    { name: "Chromium", testIgnore: ofFirefox },
    {
      name: "Firefox",
      testMatch: isThere("QUATLAS_FIREFOX") ? [inEveryEngine, ofFirefox] : [],
      use: { engineName: "firefox" },
    },
    {
      name: "WebKit",
      testMatch: isThere("QUATLAS_WEBKIT") ? inEveryEngine : [],
      use: { engineName: "webkit" },
    },
  ],
  webServer: {
    command: `vite preview --config www/vite.config.ts --port ${port} --strictPort`,
    cwd: "../..",
    url: `http://localhost:${port}/`,
    reuseExistingServer: false,
  },
});
