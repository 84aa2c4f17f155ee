// Puts the licences of all that a built page holds beside it.
import { sep } from "node:path";
import type { Plugin } from "vite";
import { cratesInWasm, licencesText, nodePackage, ownLicences } from "./licences.mjs";

const title = "quatlas, and what the page of it is made of: licences and notices.";

/** `preact` or `@preact/signals` of a file in it; nothing for a file of our own. */
function packageOf(file: string): string | undefined {
  const [, inside] = file.replaceAll(sep, "/").split(/\/?node_modules\/(?!.*node_modules\/)/);
  return inside?.match(/^(?:@[^/]+\/)?[^/]+/)?.[0];
}

export function pageLicences(): Plugin {
  return {
    name: "quatlas:licences",
    apply: "build",
    generateBundle(_, bundle) {
      const files = Object.values(bundle).flatMap((part) =>
        part.type === "chunk" ? part.moduleIds : part.originalFileNames,
      );
      const names = new Set(files.map(packageOf).filter((name) => name !== undefined));
      const packages = [...names].sort().map(nodePackage);
      const source = licencesText(title, [ownLicences(), ...packages, ...cratesInWasm()]);
      this.emitFile({ type: "asset", fileName: "licences.txt", source });
    },
  };
}
