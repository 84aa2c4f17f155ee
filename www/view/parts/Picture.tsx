// The place of the picture: as large before it is loaded as after, so that nothing moves.
import type { ComponentType } from "preact";
import { useEffect, useState } from "preact/hooks";
import type { Store } from "../../state/store.ts";
import { pictureWords as words } from "../../words/picture.ts";
import "./result.css";
import "./picture.css";

type Kind = "read" | "compose";

const parts: Record<Kind, () => Promise<ComponentType<{ store: Store }>>> = {
  read: () => import("../../picture/ReadPicture.tsx").then(({ ReadPicture }) => ReadPicture),
  compose: () =>
    import("../../picture/ComposePicture.tsx").then(({ ComposePicture }) => ComposePicture),
};

/** The picture of a view, which is loaded after the numbers. */
export function Picture({ store, of }: { store: Store; of: Kind }) {
  const [Shown, setShown] = useState<ComponentType<{ store: Store }>>();
  const [state, setState] = useState<"loading" | "failed">("loading");
  useEffect(() => {
    let isHere = true;
    parts[of]().then(
      (loaded) => isHere && setShown(() => loaded),
      () => isHere && setState("failed"),
    );
    return () => {
      isHere = false;
    };
  }, [of]);
  return (
    <section class={`card picture picture-of-${of}`} aria-label={words.name}>
      {Shown ? <Shown store={store} /> : <p class="picture-wait">{words[state]}</p>}
    </section>
  );
}
