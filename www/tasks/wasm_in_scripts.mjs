// For Vite: a wasm that a script carries (`?packed`) or has beside it (`?beside`), and the glue of wasm-bindgen.
import { readFileSync } from "node:fs";
import { basename, join } from "node:path";
import { deflateRawSync } from "node:zlib";
import { root } from "./shell.mjs";

const glue = /\/pkg\/(?:\w+\/)?quatlas\w*\.js$/;
const codec = join(root, "www", "package", "text_codec.ts").replaceAll("\\", "/");

/** Stands for the name of a file until the script is written: Vite would put the file into the script. */
const placeholder = (file) => `__BESIDE_${Buffer.from(file).toString("hex")}__`;
const placeholders = /__BESIDE_((?:[0-9a-f]{2})+)__/g;

/** A wasm as `unpacked` of www/package/packed.ts reads it. */
const packed = (bytes) => ({
  size: bytes.length,
  base64: deflateRawSync(bytes, { level: 9, memLevel: 9 }).toString("base64"),
});

export function wasmInScripts() {
  return {
    name: "wasm-in-scripts",
    enforce: "pre",
    load(id) {
      const [file, form] = id.split("?");
      if (!file.endsWith(".wasm")) return null;
      if (form === "packed") {
        return `export default ${JSON.stringify(packed(readFileSync(file)))};`;
      }
      if (form !== "beside") return null;
      const fileName = basename(file);
      this.emitFile({ type: "asset", fileName, source: readFileSync(file) });
      return `export default () => new URL(${placeholder(fileName)}, import.meta.url);`;
    },
    transform(code, id) {
      if (!glue.test(id)) return null;
      // The entry says where the wasm is; what a test in jsdom lacks as globals is imported.
      const [withoutAddress, count] = replaced(code, /new URL\('[^']*', import\.meta\.url\)/);
      if (count !== 1) this.error(`${id} does not look for its wasm as it did`);
      return `import { TextDecoder, TextEncoder } from ${JSON.stringify(codec)};\n${withoutAddress}`;
    },
    renderChunk: (code) => code.replace(placeholders, (_, hex) => `"./${Buffer.from(hex, "hex")}"`),
  };
}

function replaced(code, pattern) {
  const parts = code.split(pattern);
  return [parts.join("undefined"), parts.length - 1];
}
