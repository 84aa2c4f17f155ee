// What is loaded when a value is first copied as code.
export { originOf } from "./origin.ts";
export { preview, written } from "./write.ts";
