// Keeps the title of the tab what the page shows, so that tabs and the history can be told apart.
import { useEffect } from "preact/hooks";
import type { Store } from "../../state/store.ts";

/** As long nothing changes before the title does: whoever types or turns needs none meanwhile. */
const restMs = 300;

/** After every change of the page; its words come after the first result. */
export function useCaseTitle(store: Store) {
  useEffect(() => {
    const timer = setTimeout(() => {
      // Where they cannot be loaded, the title stays as it is.
      import("./case_title.ts").then(
        ({ caseTitle }) => {
          document.title = caseTitle(store);
        },
        () => undefined,
      );
    }, restMs);
    return () => clearTimeout(timer);
  });
}
