// A worked case: what is typed and chosen, and of which view.
import { opening, type PageState, type View } from "../page_state.ts";

export interface Example {
  view: View;
  /** What it puts in; the rest of its view is as at the opening. */
  input: Partial<PageState>;
}

/** What a view is asked, which an example replaces; texts of other views and settings stay. */
const asked = {
  read: ["preset", "axes", "matrix", "euler", "quaternion", "vector"],
  compose: ["preset", "axes", "matrix", "p", "q", "vector"],
  motion: [
    "preset",
    "axes",
    "matrix",
    "euler",
    "quaternion",
    "rate",
    "rateEnd",
    "duration",
    "increment",
    "covariance",
    "point",
    "motion",
  ],
  frames: ["preset", "axes", "matrix", "frames"],
  translate: ["translated", "from", "to", "worldAxes", "bodyAxes"],
  identify: ["observations", "libraryName", "language", "unavailable", "numbers", "beside"],
  libraries: ["find", "library"],
} as const satisfies Record<View, readonly (keyof PageState)[]>;

/** The state that an example leads to from another. */
export function stateOf({ view, input }: Example, state: PageState): PageState {
  const first = Object.fromEntries(asked[view].map((name) => [name, opening[name]]));
  return { ...state, ...first, ...input, view };
}
