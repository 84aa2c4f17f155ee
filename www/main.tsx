// Start: load the engine, mount the page, keep the address and the state in step.
import { render } from "preact";
import { toFragment } from "./address.ts";
import { loadEngine } from "./engine.ts";
import { showTheme } from "./settings.ts";
import { startShortcuts } from "./shortcuts.ts";
import { createStore, type Store } from "./state.ts";
import "./style.css";
import "./view/edit.css";
import "./view/comfort.css";
import "./view/identify.css";
import "./view/identify_answer.css";
import "./view/libraries.css";
import "./view/notes.css";
import "./view/picker.css";
import "./view/picture.css";
import "./view/translate.css";
import { releaseOnLeaving } from "./view/hold.ts";
import "./view/surroundings.css";
import { Page } from "./view/Page.tsx";
import { undoByKey } from "./view/undo_keys.ts";

const root = document.getElementById("page");
if (root === null) throw new Error("index.html has no element #page");

loadEngine().then(
  (engine) => {
    const store = createStore(engine, location.hash);
    root.replaceChildren();
    render(<Page store={store} />, root);
    keepAddress(store);
    releaseOnLeaving();
    undoByKey(store);
    showTheme();
    startShortcuts(store);
  },
  (error: unknown) => {
    root
      .querySelector("[data-loading]")
      ?.replaceChildren(
        `The core could not be loaded (${error}). Reload the page; a strict content policy must allow 'wasm-unsafe-eval'.`,
      );
  },
);

/** Browsers refuse more than about a hundred changes of the address in half a minute. */
const addressDelayMs = 300;

function keepAddress(store: Store) {
  let pending: ReturnType<typeof setTimeout> | undefined;
  let opened = store.state.peek();
  const write = () => {
    clearTimeout(pending);
    // What a newer quatlas wrote stays whole until something is changed.
    if (store.isLinkNewer.peek() && store.state.peek() === opened) return;
    history.replaceState(null, "", `#${toFragment(store.state.peek())}`);
  };
  store.state.subscribe(() => {
    clearTimeout(pending);
    pending = setTimeout(write, addressDelayMs);
  });
  addEventListener("pagehide", write);
  // A link leaves a history entry behind: it must hold what was typed just before.
  addEventListener("click", write, { capture: true });
  // The address may have been written again since it changed.
  addEventListener("hashchange", ({ newURL }) => {
    clearTimeout(pending);
    store.open(new URL(newURL).hash);
    opened = store.state.peek();
  });
}
