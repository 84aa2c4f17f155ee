// The addresses of the site and of the repository: from the environment of the build, or else from
// package.json, or not at all; then what needs one is left out.
import { readFileSync } from "node:fs";
import { join } from "node:path";
import type { HtmlTagDescriptor, Plugin } from "vite";

export interface Home {
  /** Where the page is served, with a slash at its end. */
  site: string | undefined;
  /** Where its source and its issues are, without one. */
  repository: string | undefined;
}

/** The fields of package.json that may name them. */
export interface Manifest {
  homepage?: string;
  repository?: string | { url: string };
}

/** `QUATLAS_SITE` and `QUATLAS_REPOSITORY` come before what package.json says. */
export function homeOf(
  environment: Readonly<Record<string, string | undefined>>,
  { homepage, repository }: Manifest,
): Home {
  const ofManifest = typeof repository === "string" ? repository : repository?.url;
  return {
    site: addressOf(environment["QUATLAS_SITE"] || homepage)?.replace(/\/*$/, "/"),
    repository: addressOf(environment["QUATLAS_REPOSITORY"] || ofManifest)?.replace(/\/+$/, ""),
  };
}

/** An address of the web, as npm writes it (`git+https://….git`) or as it is; nothing for another. */
function addressOf(text: string | undefined): string | undefined {
  const address = text?.replace(/^git\+/, "").replace(/\.git$/, "");
  return address?.startsWith("https://") && URL.canParse(address) ? address : undefined;
}

/** What the head of the page says of its own address: what is shared of any case is the same. */
export function headOf({ site }: Home): HtmlTagDescriptor[] {
  if (site === undefined) return [];
  const open = (property: string, content: string): HtmlTagDescriptor => ({
    tag: "meta",
    attrs: { property, content },
  });
  return [
    { tag: "link", attrs: { rel: "canonical", href: site } },
    open("og:url", site),
    open("og:image", `${site}icon_512.png`),
  ];
}

/** Those of the build that runs. */
export function homeOfBuild(): Home {
  const manifest = join(import.meta.dirname, "..", "..", "package.json");
  return homeOf(process.env, JSON.parse(readFileSync(manifest, "utf8")));
}

export function home(addresses = homeOfBuild()): Plugin {
  return {
    name: "quatlas:home",
    config: () => ({
      define: { repositoryAddress: JSON.stringify(addresses.repository) ?? "undefined" },
    }),
    // Behind the policy of the page, which comes first of all.
    transformIndexHtml: () => headOf(addresses).map((tag) => ({ ...tag, injectTo: "head" })),
  };
}
