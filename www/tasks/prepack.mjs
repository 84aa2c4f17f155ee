// Before npm pack: everything that the package holds is built from the sources.
import { buildPackage } from "./package.mjs";
import { buildCore, setUp } from "./setup.mjs";
import { main } from "./shell.mjs";

await main(async () => {
  await setUp();
  await buildCore();
  await buildPackage();
});
