// What Translate asks the core.
import type { Request } from "../../engine.ts";
import type { PageState } from "../../model/page_state.ts";

export function askedOfTranslate(state: PageState): Request {
  const { translated: quaternion, from, to, worldAxes, bodyAxes } = state;
  return { view: "translate", quaternion, from, to, worldAxes, bodyAxes };
}
