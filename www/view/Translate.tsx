// The Translate view: from one library to another.
import type { Store } from "../state.ts";

export function Translate({ store }: { store: Store }) {
  const shownResult = store.translate.value;
  return (
    <section class="ask" aria-label="Input">
      {shownResult && (
        <div class={`result ${shownResult.freshness}`}>{shownResult.report.change}</div>
      )}
    </section>
  );
}

/** What a screen reader hears when the result changes. */
export function spokenTranslation(store: Store): string {
  return store.translate.value?.report.change ?? "";
}
