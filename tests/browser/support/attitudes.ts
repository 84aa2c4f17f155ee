// Attitudes, vectors and turns that are the same in every run, and reports of them from the core.
import { readFileSync } from "node:fs";
import { analyze, initSync, presets } from "../../../pkg/quatlas.js";
import type { Convention, ReadReport } from "../../../www/engine.ts";
import { ofNormOne, type Quaternion, type Vector } from "../../../www/picture/space.ts";

initSync({ module: readFileSync(new URL("../../../pkg/quatlas_bg.wasm", import.meta.url)) });

export const { hamilton, jpl } = presets();

export function reportOf(quaternion: string, vector: string, convention: Convention): ReadReport {
  const outcome = analyze({ view: "read", quaternion, vector, convention });
  if (outcome.status !== "read") throw new Error(`${quaternion} is not read`);
  return outcome;
}

/** Numbers from 0 to 1 from a seed (Mulberry32). */
export function randomFrom(seed: number): () => number {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let mixed = Math.imul(state ^ (state >>> 15), 1 | state);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32;
  };
}

/** As likely in any direction. */
export function randomVector(random: () => number): Vector {
  const [up, around] = [2 * random() - 1, 2 * Math.PI * random()];
  const across = Math.sqrt(1 - up * up);
  return [across * Math.cos(around), across * Math.sin(around), up];
}

/** Any attitude is as likely as any other (Shoemake 1992). */
export function randomAttitude(random: () => number): Quaternion {
  const part = random();
  const [one, other] = [2 * Math.PI * random(), 2 * Math.PI * random()];
  const [near, far] = [Math.sqrt(1 - part), Math.sqrt(part)];
  return ofNormOne({
    w: far * Math.cos(other),
    x: near * Math.sin(one),
    y: near * Math.cos(one),
    z: far * Math.sin(other),
  });
}

export const asText = ({ w, x, y, z }: Quaternion) => `w=${w} x=${x} y=${y} z=${z}`;
