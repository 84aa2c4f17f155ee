// A dialog over the page; what it holds is loaded when it is first opened.
import type { FunctionComponent } from "preact";
import { useEffect, useLayoutEffect, useRef, useState } from "preact/hooks";
import type { OverlayName } from "../../model/overlay_name.ts";
import { hideOverlay, type Overlay as Opening, shownOverlay } from "../../state/overlay.ts";
import type { Store } from "../../state/store.ts";
import { close, loading, notLoaded, overlayNames } from "../../words/frame/overlay.ts";
import "./overlay.css";

type Content = FunctionComponent<{ store: Store; hide: () => void }>;

const contents: Record<OverlayName, () => Promise<Content>> = {
  help: async () => (await import("./Help.tsx")).Help,
  gallery: async () => (await import("./Gallery.tsx")).Gallery,
};

export function Overlay({ store }: { store: Store }) {
  const opening = shownOverlay.value;
  return opening === undefined ? null : <Dialog key={opening} opening={opening} store={store} />;
}

function Dialog({ opening, store }: { opening: Opening; store: Store }) {
  const { name } = opening;
  const hide = () => hideOverlay(opening);
  const dialog = useRef<HTMLDialogElement>(null);
  const [content, setContent] = useState<{ Shown: Content } | "loading" | "failed">("loading");

  // Modal: the browser keeps the focus inside and gives it back on closing.
  useLayoutEffect(() => {
    const element = dialog.current;
    element?.showModal();
    return () => element?.close();
  }, []);
  useEffect(() => {
    contents[name]().then(
      (Shown) => setContent({ Shown }),
      () => setContent("failed"),
    );
  }, [name]);

  return (
    <dialog
      ref={dialog}
      class={`overlay overlay-${name}`}
      aria-labelledby="overlay-name"
      onClose={hide}
      // Escape, and a click beside it.
      {...{ closedby: "any" }}
    >
      <div class="overlay-box">
        <header>
          <h2 id="overlay-name">{overlayNames[name]}</h2>
          <button type="button" class="tool" onClick={hide}>
            <svg viewBox="0 0 16 16" width="16" height="16" aria-hidden="true">
              <path d="M3.5 3.5 L12.5 12.5 M12.5 3.5 L3.5 12.5" />
            </svg>
            <span class="visually-hidden">{close}</span>
          </button>
        </header>
        {content === "loading" && <p>{loading}</p>}
        {content === "failed" && <p role="alert">{notLoaded}</p>}
        {typeof content === "object" && <content.Shown store={store} hide={hide} />}
      </div>
    </dialog>
  );
}
