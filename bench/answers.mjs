// node bench/answers.mjs: how long the built package takes for each request, beside one `read` in the same run.
// The largest requests that are read: 240 steps, 32 poses with as many loops, 32 factors.
import { createRequire } from "node:module";

const quatlas = createRequire(import.meta.url)("../dist/npm/quatlas.js");
const { atlas, between, chain, compose, frames, HAMILTON, JPL, motion, read, swingTwist } = quatlas;

const p = "rotvec 0.4 -0.7 1.1";
const q = "rotvec -0.6 0.25 0.9";
const vector = "1 2 3";
const pose = (at) => ({
  parent: `F${Math.floor(at / 2)}`,
  child: `F${at + 1}`,
  rotation: `rotvec 0.${at} -0.2 0.3`,
  position: [at, 1, 2],
});
const poses = Array.from({ length: 16 }, (_, at) => pose(at));
const looped = [...poses, ...poses.map((of) => ({ ...of, rotation: "1 0 0 0" }))];
const rates = { rate: [0.3, -0.2, 0.5], rateEnd: [0.1, 0.4, -0.6], duration: "2 s" };

const asked = {
  read: () => read({ quaternion: p, vector, convention: JPL }),
  compose: () => compose({ p, q, vector, convention: JPL }),
  between: () => between({ p, q, convention: JPL }),
  "chain of 32": () => chain({ factors: Array(32).fill({ text: p }), convention: JPL }),
  atlas: () => atlas({ quaternion: p, convention: JPL }),
  "swing and twist": () => swingTwist({ quaternion: p, axis: "0 0 1", convention: JPL }),
  "motion of 40 steps": () => motion({ quaternion: p, convention: JPL, ...rates, steps: 40 }),
  "motion of 240 steps": () => motion({ quaternion: p, convention: JPL, ...rates, steps: 240 }),
  "frames of 32 poses": () =>
    frames({ poses: looped, child: "F15", parent: "F16", point: [1, 2, 3], convention: HAMILTON }),
};

const times = Object.fromEntries(Object.keys(asked).map((name) => [name, []]));
for (let round = 0; round < 60; round += 1) {
  for (const [name, ask] of Object.entries(asked)) {
    const start = performance.now();
    ask();
    times[name].push(performance.now() - start);
  }
}
const median = (numbers) => numbers.toSorted((one, other) => one - other)[numbers.length >> 1];
const one = median(times.read);
for (const [name, all] of Object.entries(times)) {
  const ms = median(all);
  console.log(
    `${name.padEnd(20)} ${ms.toFixed(2).padStart(6)} ms  ${(ms / one).toFixed(1)} × read`,
  );
}
