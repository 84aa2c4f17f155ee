// A fold that asks the whole core: both come when it is opened, and the address says which are open.
import type { ComponentType } from "preact";
import { useEffect } from "preact/hooks";
import { readOn } from "../../action/read_on.ts";
import type { Store } from "../../state/store.ts";
import { waits } from "../../words/parts/later.ts";
import { useLater } from "./later.ts";
import "./fold.css";

type Load = () => Promise<ComponentType<{ store: Store }>>;

export function AskedFold({
  store,
  name,
  summary,
  load,
}: {
  store: Store;
  name: string;
  summary: string;
  load: Load;
}) {
  const others = store.state.value.open.split(",").filter((other) => other !== "");
  const isOpen = others.includes(name);
  const toggled = isOpen ? others.filter((other) => other !== name) : [...others, name];
  return (
    <div class="fold">
      <button
        type="button"
        aria-expanded={isOpen}
        onClick={() => store.set({ open: toggled.join() })}
      >
        {summary}
      </button>
      {isOpen && <Opened store={store} load={load} />}
    </div>
  );
}

function Opened({ store, load }: { store: Store; load: Load }) {
  const Body = useLater(load);
  useEffect(() => {
    if (!store.engine.isWhole) readOn(store);
  }, [store]);
  if (typeof Body !== "string" && store.engine.isWhole) return <Body store={store} />;
  const isMissing = Body === "failed" || store.wholeCore.value === "missing";
  return <p class="fold-wait">{waits[isMissing ? "failed" : "loading"]}</p>;
}
