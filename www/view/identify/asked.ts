// What Identify asks the core.
import type { Request } from "../../engine.ts";
import { declaredConvention } from "../../model/conventions.ts";
import type { PageState } from "../../model/page_state.ts";

export function askedOfIdentify(state: PageState): Request {
  const { observations, libraryName: name, language, unavailable } = state;
  return {
    view: "identify",
    observations: [...observations],
    name,
    language,
    unavailable: [...unavailable],
  };
}

/** What is asked of the numbers beside an attitude; nothing where there are none, or in another view. */
export function askedOfNumbers(state: PageState): Request | undefined {
  const { view, numbers, beside: quaternion, matrix } = state;
  if (view !== "identify" || numbers.trim() === "") return undefined;
  return { view: "numbers", numbers, quaternion, convention: declaredConvention(state), matrix };
}
