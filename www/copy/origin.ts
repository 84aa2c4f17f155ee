// Where a copied value comes from: what was typed, and the link to it.
import { version } from "../../package.json";
import { endToText } from "../address/ends.ts";
import { fromFragment } from "../address/fragment.ts";
import type { PageState } from "../model/page_state.ts";
import type { Origin } from "./writers/json.ts";

/** The origin of a value that is shown in a place of the page. */
export function originOf(place: Element | null): Origin {
  // A result that stays while its text has a problem is not of the texts in the address.
  if (place === null || place.closest(".result:is(.old, .opening)")) return { version };
  // A click writes the address before anything else sees it.
  return { version, source: textsOf(fromFragment(location.hash)), link: location.href };
}

function textsOf(state: PageState): Record<string, string> {
  const { p, q, vector, quaternion, translated, preset: as, axes } = state;
  switch (state.view) {
    case "compose":
      return { p, q, vector, as, ...axes };
    case "motion": {
      const { rate, rateEnd, duration, increment, covariance, point, motion } = state;
      return {
        quaternion,
        rate,
        rateEnd,
        duration,
        increment,
        covariance,
        point,
        motion,
        as,
        ...axes,
      };
    }
    case "frames":
      return { frames: state.frames, as, ...axes };
    case "translate":
      return { quaternion: translated, from: endToText(state.from), to: endToText(state.to) };
    default:
      return { quaternion, vector, as, ...axes };
  }
}
