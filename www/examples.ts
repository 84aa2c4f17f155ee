// Worked cases, each one click away: what is typed and chosen, and of which view.
import { opening, type PageState, type View } from "./address.ts";

export interface Example {
  view: View;
  /** What it puts in; the rest of its view is as at the opening. */
  input: Partial<PageState>;
}

/** What a view is asked, which an example replaces; texts of other views and settings stay. */
const asked = {
  read: ["preset", "axes", "matrix", "euler", "quaternion", "vector"],
  compose: ["preset", "axes", "matrix", "p", "q", "vector"],
  translate: ["translated", "from", "to", "worldAxes", "bodyAxes"],
  identify: ["observations", "libraryName", "language", "unavailable"],
  libraries: ["find", "library"],
} as const satisfies Record<View, readonly (keyof PageState)[]>;

/** The state that an example leads to from another. */
export function stateOf({ view, input }: Example, state: PageState): PageState {
  const first = Object.fromEntries(asked[view].map((name) => [name, opening[name]]));
  return { ...state, ...first, ...input, view };
}

/** Those that stand in the Read view; the others are in the gallery. */
export const featured = {
  "turn-about-z": { view: "read", input: {} },
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
