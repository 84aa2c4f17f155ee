// What unpacks a wasm where nothing else does.
export { inflateSync } from "fflate";
