// Keeps the title of the tab what the page shows, so that tabs and the history can be told apart; and
// what stands of it at the end of a print.
import { signal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import type { Store } from "../../state/store.ts";

/** As long nothing changes before the title does: whoever types or turns needs none meanwhile. */
const restMs = 300;

/** What the page shows in words, and its address. */
export const shownCase = signal<{ title: string; address: string } | undefined>(undefined);

/** After every change of the page; its words come after the first result. */
export function useCaseTitle(store: Store) {
  useEffect(() => {
    const timer = setTimeout(() => {
      // Where they cannot be loaded, the title stays as it is.
      import("./case_title.ts").then(
        ({ caseTitle, sharedAddress }) => {
          const title = caseTitle(store);
          document.title = title;
          shownCase.value = { title, address: sharedAddress(store) };
        },
        () => undefined,
      );
    }, restMs);
    return () => clearTimeout(timer);
  });
}
