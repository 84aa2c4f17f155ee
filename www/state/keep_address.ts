// Keeps the address and the state in step.
import { toFragment } from "../address/fragment.ts";
import type { Store } from "./store.ts";

/** Browsers refuse more than about a hundred changes of the address in half a minute. */
const addressDelayMs = 300;

export function keepAddress(store: Store) {
  let pending: ReturnType<typeof setTimeout> | undefined;
  let opened = store.state.peek();
  // What a newer quatlas wrote stays whole until something is changed.
  const staysWhole = () => store.isLinkNewer.peek() && store.state.peek() === opened;
  const write = () => {
    clearTimeout(pending);
    if (staysWhole()) return;
    writeAddress(toFragment(store.state.peek()));
  };
  store.state.subscribe(() => {
    clearTimeout(pending);
    pending = setTimeout(write, addressDelayMs);
  });
  addEventListener("pagehide", () => {
    if (staysWhole()) return;
    remember({ address: location.hash, fragment: toFragment(store.state.peek()) });
    write();
  });
  // A link leaves a history entry behind: it must hold what was typed just before.
  addEventListener("click", write, { capture: true });
  addEventListener("hashchange", ({ newURL }) => {
    clearTimeout(pending);
    // The address itself may have been written again between the change and this event.
    store.open(new URL(newURL).hash);
    opened = store.state.peek();
  });
}

/** What is refused, as an address beyond a megabyte is by some, is remembered when the page closes. */
function writeAddress(fragment: string) {
  try {
    history.replaceState(null, "", `#${fragment}`);
  } catch {}
}

/**
 * A reload, and a return, take the address as it was before the page closed: what was typed since
 * the last writing would be lost. So it is remembered in the tab, with the address it belongs to.
 */
interface Closing {
  address: string;
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
    const { address, fragment }: Closing = JSON.parse(remembered);
    if (address === location.hash) writeAddress(fragment);
  } catch {}
}
