// What www/tasks/wasm_in_scripts.mjs makes of a file of wasm.

/** Its bytes, for `unpacked`. */
declare module "*.wasm?packed" {
  const packed: import("./packed.ts").Packed;
  export default packed;
}

/** The file, copied to where the script is. */
declare module "*.wasm?beside" {
  const urlOf: () => URL;
  export default urlOf;
}
