// Start: load the engine, mount the page, keep the address and the state in step.
import "./style.css";
import { startPasting } from "./action/paste.ts";
import { readOn, readOnWhereNeeded } from "./action/read_on.ts";
import { startShortcuts } from "./action/shortcuts.ts";
import { undoByKey } from "./action/undo_by_key.ts";
import { fromFragment } from "./address/fragment.ts";
import { holdWhileTyping, releaseOnLeaving } from "./dom/hold.ts";
import { keepLetters } from "./dom/letters.ts";
import { composed } from "./dom/meanwhile.ts";
import { lookAtPlatform } from "./dom/platform.ts";
import { keepAddress, restoreAddress } from "./state/keep_address.ts";
import { followTheme, rememberedNumbers, showTheme } from "./state/settings.ts";
import { createStore } from "./state/store.ts";
import { beginWith, loadFile } from "./view/frame/lazy_views.ts";
import { mount } from "./view/frame/mount.tsx";
import { coreForbidden, coreNotLoaded } from "./words/frame/loading.tsx";

const root = document.getElementById("page");
if (root === null) throw new Error("index.html has no element #page");

restoreAddress();
beginWith(fromFragment(location.hash).view).then(
  async (engine) => {
    const store = createStore(engine, location.hash, rememberedNumbers);
    // Of a link that the first core cannot read the frame stays until the whole one has.
    if (store.mayBeRead.peek()) await readOn(store);
    await composed();
    mount(store, root);
    readOnWhereNeeded(store);
    lookAtPlatform();
    keepAddress(store);
    releaseOnLeaving();
    holdWhileTyping();
    undoByKey(store);
    showTheme();
    followTheme();
    startShortcuts(store);
    startPasting(store);
    // The other view of the same core opens at once.
    whenIdle(() => loadFile("compose"));
    whenIdle(keepLetters);
    if (import.meta.env.PROD) whenIdle(loadOffline);
  },
  (error: unknown) => {
    const words = isForbidden(error) ? coreForbidden : coreNotLoaded;
    document.querySelector("[data-loading]")?.setAttribute("hidden", "");
    const line = document.querySelector("[data-not-started]");
    line?.querySelector("span")?.replaceChildren(words(String(error)));
    line?.removeAttribute("hidden");
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
  import("./view/frame/offline.tsx").then(
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
