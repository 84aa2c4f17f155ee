// The Libraries view: what each library means by four numbers.
import type { Store } from "../state.ts";

export function Libraries({ store }: { store: Store }) {
  return <p class="result">{store.engine.libraries.length} records.</p>;
}

/** What a screen reader hears when the result changes. */
export function spokenLibraries(store: Store): string {
  return `${store.engine.libraries.length} records.`;
}
