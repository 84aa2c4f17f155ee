// Start: load the engine, mount the page, keep the address and the state in step.
import { render } from "preact";
import { fromFragment } from "./address.ts";
import { loadSmallEngine, loadWholeEngine } from "./engine.ts";
import { keepAddress, restoreAddress } from "./keep_address.ts";
import { isLazy } from "./lazy_views.ts";
import { followTheme, showTheme } from "./settings.ts";
import { startShortcuts } from "./shortcuts.ts";
import { createStore } from "./state.ts";
import "./style.css";
import "./view/ask.css";
import "./view/result.css";
import "./view/compose.css";
import "./view/declared.css";
import "./view/narrow.css";
import "./view/edit.css";
import "./view/comfort.css";
import "./view/loading.css";
import "./view/notes.css";
import "./view/picture.css";
import "./view/quiet.css";
import "./view/surroundings.css";
import { releaseOnLeaving } from "./view/hold.ts";
import { Page } from "./view/Page.tsx";
import { undoByKey } from "./view/undo_keys.ts";
import { coreForbidden, coreNotLoaded } from "./words/loading.tsx";

const root = document.getElementById("page");
if (root === null) throw new Error("index.html has no element #page");

restoreAddress();
// A view that needs the whole core begins with it.
const { view } = fromFragment(location.hash);
const engine = isLazy(view) ? loadWholeEngine() : loadSmallEngine();

engine.then(
  (engine) => {
    const store = createStore(engine, location.hash);
    root.replaceChildren();
    render(<Page store={store} />, root);
    keepAddress(store);
    releaseOnLeaving();
    undoByKey(store);
    showTheme();
    followTheme();
    startShortcuts(store);
    if (import.meta.env.PROD) whenIdle(loadOffline);
  },
  (error: unknown) => {
    const words = isForbidden(error) ? coreForbidden : coreNotLoaded;
    root.querySelector("[data-loading]")?.replaceChildren(words(String(error)));
  },
);

/** Whether a content policy forbids to compile the core: the error is of another type where it cannot be fetched. */
function isForbidden(error: unknown): boolean {
  const isOfPolicy = error instanceof WebAssembly.CompileError || error instanceof EvalError;
  // A file that is damaged does not compile either, and no policy is to blame for it.
  return isOfPolicy && /unsafe-eval|content security policy|\bCSP\b/i.test(error.message);
}

/** Without a network on the first visit, the next one tries again. */
const loadOffline = () =>
  import("./offline.tsx").then(
    ({ keepOffline }) => keepOffline(),
    () => undefined,
  );

/** Once the page has loaded and has nothing else to do. */
function whenIdle(run: () => void) {
  if (document.readyState !== "complete") addEventListener("load", () => whenIdle(run));
  // Safari has no idle callback.
  else if ("requestIdleCallback" in window) requestIdleCallback(run);
  else setTimeout(run, 1000);
}
