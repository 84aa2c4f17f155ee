// Start: load the engine, mount the page, keep the address and the state in step.
import { render } from "preact";
import { fromFragment, toFragment } from "./address.ts";
import { loadSmallEngine, loadWholeEngine } from "./engine.ts";
import { isLazy } from "./lazy_views.ts";
import { createStore, type Store } from "./state.ts";
import "./style.css";
import "./view/loading.css";
import "./view/quiet.css";
import { Page } from "./view/Page.tsx";
import { coreNotLoaded } from "./words/loading.tsx";

const root = document.getElementById("page");
if (root === null) throw new Error("index.html has no element #page");

// A view that needs the whole core begins with it.
const { view } = fromFragment(location.hash);
const engine = isLazy(view) ? loadWholeEngine() : loadSmallEngine();

engine.then(
  (engine) => {
    const store = createStore(engine, location.hash);
    root.replaceChildren();
    render(<Page store={store} />, root);
    keepAddress(store);
  },
  (error: unknown) => {
    root.querySelector("[data-loading]")?.replaceChildren(coreNotLoaded(String(error)));
  },
);

/** Browsers refuse more than about a hundred changes of the address in half a minute. */
const addressDelayMs = 300;

function keepAddress(store: Store) {
  let pending: ReturnType<typeof setTimeout> | undefined;
  const write = () => {
    clearTimeout(pending);
    history.replaceState(null, "", `#${toFragment(store.state.peek())}`);
  };
  store.state.subscribe(() => {
    clearTimeout(pending);
    pending = setTimeout(write, addressDelayMs);
  });
  addEventListener("pagehide", write);
  // A link leaves a history entry behind: it must hold what was typed just before.
  addEventListener("click", write, { capture: true });
  addEventListener("hashchange", () => {
    clearTimeout(pending);
    store.open(location.hash);
  });
}
