// The Identify view: which convention a library uses.
import type { Store } from "../state.ts";

export function Identify({ store }: { store: Store }) {
  const shownResult = store.identify.value;
  return (
    <section class="ask" aria-label="Input">
      {shownResult && (
        <div class={`result ${shownResult.freshness}`}>{shownResult.report.sentence}</div>
      )}
    </section>
  );
}

/** What a screen reader hears when the result changes. */
export function spokenIdentity(store: Store): string {
  return store.identify.value?.report.sentence ?? "";
}
