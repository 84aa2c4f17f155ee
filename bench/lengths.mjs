// How the time to read a text grows with its length: 100 kB over 10 kB of each kind, in one run, of the core
// that `npm start` or `npm test` built. `node bench/lengths.mjs` prints the ratios, of which none may pass the goal.
import { readFileSync } from "node:fs";
import * as core from "../pkg/quatlas.js";

const goal = 12;
const runs = 5;
const [short, long] = [10_000, 100_000];

core.initSync({ module: readFileSync(new URL("../pkg/quatlas_bg.wasm", import.meta.url)) });
const { hamilton } = core.presets();

const repeated = (part) => (length) =>
  part.repeat(Math.ceil(length / part.length)).slice(0, length);

/** Texts of a length, as they are pasted or as they take the longest. */
const kinds = {
  "a log with one rotation": (length) =>
    `${repeated("[INFO] [12.5]: waiting for a transform\n")(length)}\norientation: {x: 0.1, y: 0.3, z: 0.5, w: 0.8}`,
  "a product beside a rotation": (length) =>
    `${repeated("1 * ")(length)}\norientation: {x: 0.1, y: 0.3, z: 0.5, w: 0.8}`,
  "poses in YAML": repeated(
    "position: {x: 1, y: 2, z: 3}\norientation: {x: 0.1, y: 0.3, z: 0.5, w: 0.8}\n---\n",
  ),
  "rows under names": (length) =>
    `t,x,y,z,qx,qy,qz,qw\n${repeated("1.5,1,2,3,0.1,0.3,0.5,0.8\n")(length)}`,
  "rows without names": repeated(
    "1305031102.1758 1.3405 0.6266 1.6575 0.6574 0.6126 -0.2949 -0.3248\n",
  ),
  "elements of XML": repeated('<pose rpy="0.1 0.2 0.3" xyz="1 2 3"/>\n'),
  "roll, pitch and yaw": repeated("roll: 0.1 pitch: 0.2 yaw: 0.3\n"),
  "objects of JSON": (length) => `[${repeated('{"w":1,"x":0,"y":0,"z":0},')(length)}]`,
  "numbers alone": repeated("0.1 0.2 0.3 0.4 "),
  "a word": repeated("rotation "),
  comments: (length) => `${repeated("# w x y z\n")(length)}0.1 0.3 0.5 0.8`,
  "a sum": repeated("0.5 + 0.1 i + "),
  "open brackets": repeated("[[["),
  "open braces with names": repeated("{a: "),
  "open factors": repeated("(1+"),
  commas: repeated(","),
  signs: repeated("-"),
};

/** What a text takes once, of so many times, in milliseconds. */
function readMs(text, times) {
  const start = performance.now();
  for (let time = 0; time < times; time++) {
    core.analyze({ view: "read", quaternion: text, vector: "1 0 0", convention: hamilton });
  }
  return (performance.now() - start) / times;
}

/** The least of several runs for each length, in turn and as long as each other. */
function leastMs(of) {
  const [shortText, longText] = [of(short), of(long)];
  let [shortMs, longMs] = [Infinity, Infinity];
  for (let run = 0; run < runs; run++) {
    shortMs = Math.min(shortMs, readMs(shortText, long / short));
    longMs = Math.min(longMs, readMs(longText, 1));
  }
  return [shortMs, longMs];
}

let missed = 0;
for (const [kind, of] of Object.entries(kinds)) {
  const [shortMs, longMs] = leastMs(of);
  const ratio = longMs / shortMs;
  missed += ratio > goal ? 1 : 0;
  console.log(
    `${kind.padEnd(26)} ${ratio.toFixed(1).padStart(5)}   ${longMs.toFixed(0).padStart(4)} ms`,
  );
}
console.log(`100 kB over 10 kB, at most ${goal}: ${missed === 0 ? "met" : `missed by ${missed}`}`);
process.exitCode = missed === 0 ? 0 : 1;
