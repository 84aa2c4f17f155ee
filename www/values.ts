// The core's lists of names and its named conventions, for what runs before the core is there: plain
// constants, which the build writes from the core.
export * from "../pkg/values.js";
