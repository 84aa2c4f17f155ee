// All examples, in the order of the gallery; loaded with it.
import type { Endpoint } from "../../engine.ts";
import type { Example } from "./example.ts";
import { featured } from "./featured.ts";
import { randomAttitude } from "./random_attitude.ts";

const library = (id: string): Endpoint => ({ kind: "library", id });

const further = {
  "axis-and-angle": {
    view: "read",
    input: { quaternion: "90° about [0, 1, 1]", vector: "1 0 0" },
  },
  "third-of-a-turn": {
    view: "read",
    input: { quaternion: "1/2 + i/2 + j/2 + k/2", vector: "1 2 3" },
  },
  // As a library prints C(q); read from body to world it would be the inverse.
  "transposed-matrix": {
    view: "read",
    input: {
      quaternion: "0.8 0.6 0\n-0.6 0.8 0\n0 0 1",
      matrix: { function: "passive", direction: "world-to-body" },
      vector: "1 0 0",
    },
  },
  "double-cover": {
    view: "read",
    input: { quaternion: "-cos(pi/8) - sin(pi/8) k" },
  },
  "gimbal-lock": { view: "read", input: { quaternion: "ZYX 30° 90° 10°", vector: "1 0 0" } },
  "half-turn": { view: "read", input: { quaternion: "180° about [1, 1, 0]", vector: "1 0 0" } },
  "invisible-order": { view: "read", input: { quaternion: "0.5 0.5 0.5 0.5", vector: "1 2 3" } },
  "norm-of-two": { view: "read", input: { quaternion: "1 + i + j + k", vector: "1 2 3" } },
  // Active, world to body, and beside it the passive matrix world to body.
  "my-lab": {
    view: "read",
    input: {
      axes: { function: "active", direction: "world-to-body" },
      matrix: { function: "passive", direction: "world-to-body" },
      quaternion: "rotvec 0.4 -0.7 1.1",
      vector: "1 0 0",
    },
  },
  "jpl-body-to-world": {
    view: "read",
    input: { preset: "jpl", axes: { direction: "body-to-world" }, quaternion: "0 0 0.6 0.8" },
  },
  "both-orders": { view: "compose", input: {} },
  commuting: {
    view: "compose",
    input: { p: "30° about z", q: "60° about z", vector: "1 0 0" },
  },
  "isaac-lab": {
    view: "translate",
    input: {
      translated: "0.7071067811865476 0 0 0.7071067811865476",
      from: library("isaac-lab-2"),
      to: library("isaac-lab-3"),
    },
  },
  "msckf-log": {
    view: "translate",
    input: {
      translated: "0.1 -0.2 0.4 0.888819441731559",
      from: library("msckf-vio"),
      to: library("eigen"),
    },
  },
  "px4-to-ros": {
    view: "translate",
    input: {
      translated: "0.7071067811865476 0 0 0.7071067811865476",
      from: library("px4-vehicle-attitude"),
      to: library("ros-geometry-msgs"),
      worldAxes: "NED to ENU",
      bodyAxes: "FRD to FLU",
    },
  },
  "unknown-library": { view: "identify", input: {} },
  "unknown-angles": {
    view: "identify",
    input: { numbers: "40.00, 335.00, 70.00", beside: "0.70904 0.15687 -0.35813 0.58685" },
  },
} as const satisfies Record<string, Example>;

/** Another attitude each time that it is asked for. */
const random = (): Example => ({
  view: "read",
  input: { quaternion: randomAttitude(Math.random), vector: "1 2 3" },
});

const first = { "turn-about-z": { view: "read", input: {} } } as const satisfies Record<
  string,
  Example
>;

export const gallery = { ...first, ...featured, ...further };
export type ExampleName = keyof typeof gallery | "random";
export const exampleNames = [...Object.keys(gallery), "random"] as ExampleName[];

export const exampleOf = (name: ExampleName): Example =>
  name === "random" ? random() : gallery[name];
