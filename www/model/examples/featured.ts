// The examples that stand in the Read view, each one click away.
import type { Example } from "./example.ts";

/** Those that stand in the Read view; the others are in the gallery. */
export const featured = {
  "jpl-log": {
    view: "read",
    input: { preset: "jpl", quaternion: "-0.0212 0.7031 0.0148 0.7106", vector: "0 0 -9.81" },
  },
  "ros-message": {
    view: "read",
    input: { quaternion: "x: 0.0\ny: 0.0\nz: 0.7071\nw: 0.7071", vector: "1 0 0" },
  },
  "yaw-pitch-roll": { view: "read", input: { quaternion: "ZYX 30° 20° 10°", vector: "1 0 0" } },
  matrix: {
    view: "read",
    input: { quaternion: "0.36 -0.48 0.8\n0.8 0.6 0\n-0.48 0.64 0.6", vector: "1 0 0" },
  },
} as const satisfies Record<string, Example>;
export type FeaturedName = keyof typeof featured;
