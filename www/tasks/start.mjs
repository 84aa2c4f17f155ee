// npm start: set up what is missing, build the core and the page, serve it, print its address.
import { buildCore, setUp } from "./setup.mjs";
import { main, root, say } from "./shell.mjs";

await main(async () => {
  await setUp();
  await buildCore();
  say("building the page");
  const { build, preview } = await import("vite");
  const configFile = `${root}/www/vite.config.ts`;
  await build({ configFile, logLevel: "warn" });
  const server = await preview({ configFile, logLevel: "warn" });
  const [address] = server.resolvedUrls?.local ?? [];
  say(`the page is at ${address} (Ctrl+C stops it)`);
});
