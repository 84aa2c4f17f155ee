import init, { type InitOptions, JPL, read } from "quatlas/web";

const options: InitOptions = { wasm: new URL("https://example.org/quatlas_bg.wasm") };
await init(options);
// @ts-expect-error: there is no such option
await init({ url: "" });
const report = read({ quaternion: "1 0 0 0", vector: "1 0 0", convention: JPL });
if (report.status === "read") console.log(report.jpl.unit.w satisfies number);
