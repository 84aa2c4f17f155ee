// What goes wrong, each with its angle.
import type { Mistake } from "../../engine.ts";
import { shownRoughAngle } from "../../number/format.ts";
import type { Store } from "../../state/store.ts";
import { mistakeWords } from "../../words/motion/mistakes.ts";
import * as words from "../../words/motion/motion.tsx";

export function Mistakes({ store, mistakes }: { store: Store; mistakes: readonly Mistake[] }) {
  const { unit } = store.state.value;
  return (
    <>
      <h3>{words.wrongName}</h3>
      <ul class="motion-mistakes">
        {mistakes.map(({ kind, angleDeg }) => (
          <li key={kind}>
            <span>{mistakeWords[kind]}</span>
            <span>
              {angleDeg === 0 ? words.doesNotShow : words.off(shownRoughAngle(angleDeg, unit, 4))}
            </span>
          </li>
        ))}
      </ul>
    </>
  );
}
