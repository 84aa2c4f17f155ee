// The case of one view as the case of another: the same numbers in the same convention.
import type { Convention, Endpoint } from "../engine.ts";
import { namedConventions } from "../values.ts";
import { type ComponentName, markOf, namesOf } from "./component_order.ts";
import { differing, presetOf } from "./conventions.ts";
import type { PageState } from "./page_state.ts";

/** Four numbers with the convention in which they are an attitude. */
export interface CarriedQuaternion {
  components: Readonly<Record<ComponentName, number>>;
  convention: Convention;
}

/** The views that take a quaternion. */
export type CarryTarget = "read" | "compose" | "translate";

/** What a view is to show; all else stays. In Compose it is the q: what the visitor types acts after it. */
export const carriedTo: Record<CarryTarget, (quaternion: CarriedQuaternion) => Partial<PageState>> =
  {
    read: (quaternion) => ({
      view: "read",
      quaternion: textOf(quaternion),
      ...declaring(quaternion.convention),
    }),
    compose: (quaternion) => ({
      view: "compose",
      q: textOf(quaternion),
      ...declaring(quaternion.convention),
    }),
    translate: (quaternion) => ({
      translated: textOf(quaternion),
      ...translatedFrom({ kind: "convention", convention: quaternion.convention }),
    }),
  };

/** The translation from an end, of which the axes stay. */
export function translatedFrom(from: Endpoint): Partial<PageState> {
  return { view: "translate", from, worldAxes: "", bodyAxes: "" };
}

/** Every digit, by name, in the order of the convention: nothing is left to be assumed. */
function textOf({ components, convention }: CarriedQuaternion): string {
  const mark = markOf(components);
  const parts = namesOf[convention.order].map((name) => `${mark}${name}=${components[name]}`);
  return parts.join(" ");
}

/** The choices by which four numbers are meant in a convention. */
function declaring(convention: Convention): Pick<PageState, "preset" | "axes"> {
  const preset = presetOf[convention.handedness];
  return { preset, axes: differing(convention, namedConventions[preset]) };
}
