// A page as HTML before any browser has it: what a request shows, rendered at build by the core itself.
import { renderToString } from "preact-render-to-string";
import { loadSmallEngine } from "./engine.ts";
import { createStore } from "./state/store.ts";
import { Page } from "./view/frame/Page.tsx";

/**
 * The HTML of the page of an address, as it is before what comes after the first result; `core` is the
 * small core as bytes.
 */
export async function prerendered(fragment: string, core: BufferSource): Promise<string> {
  const engine = await loadSmallEngine(core);
  const nothingRemembered = () => ({});
  return renderToString(<Page store={createStore(engine, fragment, nothingRemembered)} />);
}
