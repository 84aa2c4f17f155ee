// Sharing what the page shows: the button, the version, and what is said of a link of a newer one.
import type { ComponentType } from "preact";
import { useRef, useState } from "preact/hooks";
import { version } from "../../../package.json";
import type { Store } from "../../state/store.ts";
import { shareWords as words } from "../../words/frame/share.ts";
import type { PanelProps } from "./SharePanel.tsx";
import "./share.css";

export function Share({ store }: { store: Store }) {
  const [Panel, setPanel] = useState<ComponentType<PanelProps>>();
  const button = useRef<HTMLButtonElement>(null);
  const open = async () => {
    const { SharePanel } = await import("./SharePanel.tsx");
    setPanel(() => SharePanel);
  };
  return (
    <span class="share">
      <button
        ref={button}
        type="button"
        aria-haspopup="dialog"
        aria-expanded={Panel !== undefined}
        onClick={() => (Panel === undefined ? open() : setPanel(undefined))}
      >
        <svg viewBox="0 0 16 16" width="15" height="15" aria-hidden="true">
          <path d="M8 10 V2 M5 4.5 L8 1.8 L11 4.5 M4.5 7.5 H3 V14 H13 V7.5 H11.5" />
        </svg>
        {words.share}
      </button>
      {Panel !== undefined && button.current !== null && (
        <Panel store={store} anchor={button.current} close={() => setPanel(undefined)} />
      )}
    </span>
  );
}

/** Where the opened link may say what this version does not know. */
export function NewerLink({ store }: { store: Store }) {
  return store.isLinkNewer.value ? <p class="newer-link">{words.newer}</p> : null;
}

export function Version() {
  return <span class="version">{words.version(version)}</span>;
}
