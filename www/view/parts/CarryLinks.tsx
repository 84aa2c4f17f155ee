// Links that open a quaternion, with its convention, in other views.
import { type CarriedQuaternion, type CarryTarget, carriedTo } from "../../model/carried.ts";
import type { Store } from "../../state/store.ts";
import { carryLabel, carryWords } from "../../words/parts/carry_links.ts";
import "./carry_links.css";

export function CarryLinks({
  store,
  of,
  quaternion,
  to,
}: {
  store: Store;
  /** What the quaternion is called, for who hears the link alone. */
  of: string;
  quaternion: CarriedQuaternion;
  to: readonly CarryTarget[];
}) {
  return (
    <p class="carry-links">
      {to.map((target) => (
        <a
          key={target}
          href={store.linkTo(carriedTo[target](quaternion))}
          aria-label={carryLabel(target, of)}
        >
          {carryWords[target]}
        </a>
      ))}
    </p>
  );
}
