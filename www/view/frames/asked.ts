// What Frames asks the core.
import type { Request } from "../../engine.ts";
import { declaredConvention } from "../../model/conventions.ts";
import type { PageState } from "../../model/page_state.ts";
import { posesOf, rigOf } from "./rows.ts";

export function askedOfFrames(state: PageState): Request {
  const rig = rigOf(state.frames);
  const { child, parent, point } = rig;
  const { matrix, euler } = state;
  const convention = declaredConvention(state);
  return { view: "frames", poses: posesOf(rig), child, parent, point, convention, matrix, euler };
}
