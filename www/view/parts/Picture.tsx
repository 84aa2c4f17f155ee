// The place of the picture: as large before it is loaded as after, so that nothing moves.
import type { ComponentType } from "preact";
import type { Store } from "../../state/store.ts";
import * as words from "../../words/parts/picture_place.ts";
import { useLater } from "./later.ts";
import "./result.css";
import "./picture.css";

type Kind = "read" | "compose" | "motion" | "frames";

const parts: Record<Kind, () => Promise<ComponentType<{ store: Store }>>> = {
  read: () => import("../../picture/ReadPicture.tsx").then(({ ReadPicture }) => ReadPicture),
  motion: () =>
    import("../../picture/MotionPicture.tsx").then(({ MotionPicture }) => MotionPicture),
  frames: () =>
    import("../../picture/FramesPicture.tsx").then(({ FramesPicture }) => FramesPicture),
  compose: () =>
    import("../../picture/ComposePicture.tsx").then(({ ComposePicture }) => ComposePicture),
};

/** The picture of a view, which is loaded after the numbers. */
export function Picture({ store, of }: { store: Store; of: Kind }) {
  const Shown = useLater(parts[of]);
  return (
    <section class={`card picture picture-of-${of}`} aria-label={words.name}>
      {typeof Shown === "string" ? (
        <p class="picture-wait">{words.waits[Shown]}</p>
      ) : (
        <Shown store={store} />
      )}
    </section>
  );
}
