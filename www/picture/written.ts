// A turned pose as text for the field, in the declared convention; pure.
import type { Convention, Rules } from "../engine.ts";
import { namesOf } from "../model/component_order.ts";
import type { Digits } from "../model/page_state.ts";
import type { Quaternion } from "./space.ts";

/**
 * `w=0.9239 x=0 y=0 z=0.3827`: the components that the convention gives to a pose, with the
 * decimals that are shown. The core says whether they are Hamilton's or their conjugate.
 */
export function poseAsText(
  pose: Quaternion,
  { order }: Pick<Convention, "order">,
  { isCanonical }: Pick<Rules, "isCanonical">,
  digits: Digits,
): string {
  const sign = isCanonical ? 1 : -1;
  const components = { w: pose.w, x: sign * pose.x, y: sign * pose.y, z: sign * pose.z };
  return namesOf[order].map((name) => `${name}=${rounded(components[name], digits)}`).join(" ");
}

function rounded(number: number, digits: Digits): string {
  // Adding 0 makes no −0.
  return String((digits === "all" ? number : Number(number.toFixed(Number(digits)))) + 0);
}
