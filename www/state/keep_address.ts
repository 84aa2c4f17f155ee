// Keeps the address and the state in step.
import { toFragment } from "../address/fragment.ts";
import type { Store } from "./store.ts";

/** Browsers refuse more than about a hundred changes of the address in half a minute. */
const addressDelayMs = 300;

export function keepAddress(store: Store) {
  nameEntry();
  let pending: ReturnType<typeof setTimeout> | undefined;
  let opened = store.state.peek();
  // What a newer quatlas wrote stays whole until something is changed.
  const staysWhole = () => store.isLinkNewer.peek() && store.state.peek() === opened;
  const write = () => {
    clearTimeout(pending);
    if (staysWhole()) return;
    writeAddress(toFragment(store.addressed.peek()));
  };
  store.state.subscribe(() => {
    clearTimeout(pending);
    pending = setTimeout(write, addressDelayMs);
  });
  addEventListener("pagehide", () => {
    if (staysWhole()) return;
    // Whole, however long: what was pasted is there again.
    remember({ entry: entryName(), fragment: toFragment(store.state.peek()) });
    write();
  });
  // A link leaves a history entry behind: it must hold what was typed just before.
  addEventListener("click", write, { capture: true });
  addEventListener("hashchange", ({ newURL }) => {
    clearTimeout(pending);
    nameEntry();
    // The address itself may have been written again between the change and this event.
    store.open(new URL(newURL).hash);
    opened = store.state.peek();
  });
}

/** What is refused, as an address beyond a megabyte is by some, is remembered when the page closes. */
function writeAddress(fragment: string) {
  try {
    history.replaceState(history.state, "", `#${fragment}`);
  } catch {}
}

/**
 * The name of the entry of the history that the page stands in. The address is no name: what is written
 * into it while the browser already leaves may be lost, or not.
 */
function entryName(): string | undefined {
  const state: unknown = history.state;
  return typeof state === "string" ? state : undefined;
}

function nameEntry() {
  if (entryName() !== undefined) return;
  try {
    history.replaceState(`quatlas ${Date.now()} ${Math.random()}`, "");
  } catch {}
}

/**
 * A reload, and a return, take the address as it was before the page closed: what was typed since
 * the last writing would be lost. So it is remembered in the tab, with the entry it belongs to.
 */
interface Closing {
  entry: string | undefined;
  fragment: string;
}

const key = "quatlas closing";

function remember(closing: Closing) {
  // Absent where the visitor forbids storage.
  try {
    sessionStorage.setItem(key, JSON.stringify(closing));
  } catch {}
}

/** Gives the address what was typed just before the page closed. Before the state is read from it. */
export function restoreAddress() {
  try {
    const remembered = sessionStorage.getItem(key);
    sessionStorage.removeItem(key);
    const [visit] = performance.getEntriesByType("navigation");
    if (remembered === null || (visit as PerformanceNavigationTiming).type === "navigate") return;
    const { entry, fragment }: Closing = JSON.parse(remembered);
    if (entry !== undefined && entry === entryName()) writeAddress(fragment);
  } catch {}
}
