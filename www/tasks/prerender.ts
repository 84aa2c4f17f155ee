// The built page holds its opening example already: its HTML rendered by the core, its styles and its first
// script in it, and the hashes of these in its policy.
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { createServer, minify, type Plugin, type Rolldown } from "vite";
import { sha256 } from "./precache.ts";

const www = join(import.meta.dirname, "..");
const pkg = join(www, "..", "pkg");

type Bundle = Rolldown.OutputBundle;

/** The HTML of the page of an address, by the program itself. */
async function rendered(fragment: string, plugins: Plugin[]): Promise<string> {
  const server = await createServer({
    configFile: false,
    root: www,
    logLevel: "warn",
    appType: "custom",
    plugins,
    server: { middlewareMode: true, ws: false, watch: null },
    optimizeDeps: { noDiscovery: true },
  });
  try {
    const { prerendered } = await server.ssrLoadModule("/prerender.tsx");
    const core = readFileSync(join(pkg, "small", "quatlas_small_bg.wasm"));
    return await prerendered(fragment, core);
  } finally {
    await server.close();
  }
}

/** The page with the hashes of inline parts beside a source of its policy. */
function allowing(html: string, directive: string, parts: readonly string[]): string {
  const own = `${directive} 'self'`;
  const hashes = parts.map((part) => `'sha256-${sha256(part)}'`);
  return replaced(html, own, [own, ...hashes].join(" "));
}

/** The text with a part of it replaced, which must be there. */
function replaced(html: string, part: string | RegExp, by: string): string {
  const found = typeof part === "string" ? html.includes(part) : part.test(html);
  if (!found) throw new Error(`the page has no ${part}`);
  return html.replace(part, () => by);
}

/** The style sheet of the page, which leaves the bundle: the faces of the letters, and all other rules. */
function takeStyles(bundle: Bundle, file: string) {
  const sheet = bundle[`assets/${file}`];
  if (sheet?.type !== "asset") throw new Error(`the bundle has no ${file}`);
  delete bundle[sheet.fileName];
  const css = String(sheet.source).trim();
  // Those of files; a face may also be one of the system.
  const face = /@font-face\s*\{[^}]*url\([^}]*\}/g;
  // They were written for a sheet in the folder of assets.
  const faces = (css.match(face) ?? []).join("").replaceAll("url(./", "url(./assets/");
  return { faces, rules: css.replace(face, "") };
}

/** The links to what is asked for in its time: the cores by first.js, the letters by it or by dom/letters.ts. */
function sleepingLinks(bundle: Bundle): string {
  const link = (file: string, mark: string) => `<link ${mark} href="./${file}">`;
  const links = Object.keys(bundle).flatMap((file) => {
    if (file.includes("quatlas_small_bg")) return [link(file, 'data-core="small"')];
    if (file.includes("quatlas_bg")) return [link(file, 'data-core="whole"')];
    return file.endsWith(".woff2") ? [link(file, "data-letters")] : [];
  });
  return links.join("");
}

/** HTML without comments, and without the space that only its source needs. */
const withoutGaps = (html: string) =>
  html
    .replace(/<!--[\s\S]*?-->/g, "")
    .replace(/\s+/g, " ")
    .replaceAll("> <", "><");

const firstScript = /<script src="\.\/first\.js"><\/script>/;
const styleSheet = /<link rel="stylesheet"[^>]*href="\.\/assets\/([^"]+)">/;

/** Scripts that come later wait for the style sheets that they name: for the page's own they have not to. */
function withoutSheet(bundle: Bundle, sheet: string) {
  const scripts = Object.values(bundle).filter((output) => output.type === "chunk");
  const own = scripts.find(({ isEntry }) => isEntry)?.fileName.replace("assets/", "");
  for (const script of scripts) script.code = script.code.replaceAll(`"./${sheet}"`, `"./${own}"`);
}

export function prerender(plugins: () => Plugin[]): Plugin[] {
  let first = "";
  let sheet = "";
  return [
    {
      name: "quatlas:first-script",
      apply: "build",
      transformIndexHtml: {
        order: "pre",
        async handler(html) {
          const source = readFileSync(join(www, "first.js"), "utf8");
          first = (await minify("first.js", source)).code.trim();
          return replaced(html, firstScript, `<script>${first}</script>`);
        },
      },
    },
    {
      name: "quatlas:prerender",
      apply: "build",
      transformIndexHtml: {
        order: "post",
        async handler(html, { bundle = {} }) {
          sheet = styleSheet.exec(html)?.[1] ?? "style sheet";
          const { faces, rules } = takeStyles(bundle, sheet);
          const script = `<script>${first}</script>`;
          const letters = `<style data-letters media="not all">${faces}</style>`;
          // Where the script finds them.
          const head = `${letters}${sleepingLinks(bundle)}${script}<style>${rules}</style>`;
          let page = withoutGaps(replaced(html, script, ""));
          page = allowing(page, "script-src", [first]);
          page = allowing(page, "style-src", [faces, rules]);
          page = replaced(page, styleSheet, head);
          const empty = '<div id="page"></div>';
          return replaced(page, empty, `<div id="page">${await rendered("", plugins())}</div>`);
        },
      },
      generateBundle: {
        order: "post",
        handler: (_, bundle) => withoutSheet(bundle, sheet),
      },
    },
  ];
}
