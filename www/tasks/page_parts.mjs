// The files of the built page and their sizes: those of the first load, and those that are loaded later.
import { readdirSync, readFileSync } from "node:fs";
import { extname, join } from "node:path";
import { brotliCompressSync, gzipSync } from "node:zlib";
import { root } from "./shell.mjs";

const folder = join(root, "dist", "page");
const smallCore = /^quatlas_small_bg-/;
/** What is asked for by scripts, in its time. */
const sleepingLink = /<link data-[^>]*>/g;
const beside = /["'(`]\.\/([\w.-]+-[\w-]{8}\.\w+)/g;
const font = /\.woff2$/;

const mediaTypes = {
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript",
  ".css": "text/css",
  ".wasm": "application/wasm",
  ".woff2": "font/woff2",
  ".svg": "image/svg+xml",
  ".png": "image/png",
  ".txt": "text/plain; charset=utf-8",
  ".webmanifest": "application/manifest+json",
};

/** What a file of the page is, by its end. */
export const mediaTypeOf = (path) => mediaTypes[extname(path)] ?? "application/octet-stream";

/** How hosts send a file, each as small as it can; the best quality of brotli is that of Node by default. */
export const encodings = {
  gzip: (bytes) => gzipSync(bytes, { level: 9 }),
  br: (bytes) => brotliCompressSync(bytes),
};

/** What a bare address loads before it is idle, what may follow, and the fonts, which do not compress. */
export function partsOfPage() {
  const html = readFileSync(join(folder, "index.html"), "utf8").replace(sleepingLink, "");
  const isFirst = (file) => smallCore.test(file) || html.includes(`./assets/${file}"`);
  const files = readdirSync(join(folder, "assets")).map((file) => ({
    ...part(join("assets", file), nameOf(file)),
    file,
  }));
  const others = readdirSync(folder, { withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map(({ name }) => ({ ...part(name, name), file: name }));
  const isHtml = ({ file }) => file === "index.html";
  const all = [...files, ...others];
  const fonts = all.filter(({ file }) => font.test(file));
  const first = all.filter((part) => !fonts.includes(part) && (isHtml(part) || isFirst(part.file)));
  const lazy = all.filter((part) => !fonts.includes(part) && !first.includes(part));
  return { first, lazy, fonts };
}

export const gzipTotal = (parts) => parts.reduce((sum, { gzip }) => sum + gzip, 0);

/** The bytes of a part as brotli, which takes a while. */
export function brotliOf({ path, bytes }) {
  return font.test(path) ? bytes : encodings.br(readFileSync(join(folder, path))).length;
}

/** The files that scripts and styles name beside themselves and that are not there. */
export function missingParts() {
  const files = readdirSync(join(folder, "assets"));
  const named = (file) =>
    [...readFileSync(join(folder, "assets", file), "utf8").matchAll(beside)].map(
      ([, name]) => name,
    );
  const isText = (file) => file.endsWith(".js") || file.endsWith(".css");
  return files
    .filter(isText)
    .flatMap(named)
    .filter((name) => !files.includes(name));
}

/** The name of a built file without the hash of its content. */
function nameOf(file) {
  return file.replace(/-[\w-]{8}(?=\.\w+$)/, "");
}

function part(path, name) {
  const bytes = readFileSync(join(folder, path));
  const gzip = font.test(path) ? bytes.length : encodings.gzip(bytes).length;
  return { name, path, bytes: bytes.length, gzip };
}
