// The tabs of the page, and the row of the parts of a tab that has several.
import { useRef } from "preact/hooks";
import type { View } from "../../model/page_state.ts";
import { partsOf, type Tab, tabNames, tabOf } from "../../model/tabs.ts";
import type { Store } from "../../state/store.ts";
import { tabsLabel, tabWords, viewNames } from "../../words/frame/page.tsx";
import { isLazy, load } from "./lazy_views.ts";
import "./tabs.css";

export function Tabs({ store }: { store: Store }) {
  const { view } = store.state.value;
  const current = tabOf(view);
  // Whoever comes back to a tab finds the part that he left.
  const lastPart = useRef<Partial<Record<Tab, View>>>({});
  lastPart.current[current] = view;
  return (
    <nav class="views" aria-label={tabsLabel}>
      {tabNames.map((tab) => (
        <ViewLink
          key={tab}
          store={store}
          view={lastPart.current[tab] ?? partsOf(tab)[0] ?? view}
          isCurrent={tab === current}
          name={tabWords[tab]}
          tab={tab}
        />
      ))}
    </nav>
  );
}

/** Nothing where the tab is one view. */
export function Parts({ store }: { store: Store }) {
  const { view } = store.state.value;
  const tab = tabOf(view);
  const parts = partsOf(tab);
  if (parts.length === 1) return null;
  return (
    <nav class="parts" aria-label={tabWords[tab]}>
      {parts.map((part) => (
        <ViewLink
          key={part}
          store={store}
          view={part}
          isCurrent={part === view}
          name={viewNames[part]}
        />
      ))}
    </nav>
  );
}

function ViewLink({
  store,
  view,
  isCurrent,
  name,
  tab,
}: {
  store: Store;
  view: View;
  isCurrent: boolean;
  name: string;
  tab?: Tab;
}) {
  return (
    <a
      href={store.linkTo({ view })}
      aria-current={isCurrent ? "page" : undefined}
      data-tab={tab}
      // A pointer on the way to a view has a moment in which it can be loaded.
      onPointerEnter={() => isLazy(view) && load(view, store)}
    >
      {name}
    </a>
  );
}
