// What the core of the first load cannot read is read by the whole one.
import { effect } from "@preact/signals";
import { loadWholeEngine } from "../engine.ts";
import type { Store } from "../state/store.ts";

/** Answers with the whole core from now on, once it is there. It never throws. */
export async function readOn(store: Store) {
  store.wholeCore.value = "awaited";
  try {
    store.useEngine(await loadWholeEngine());
  } catch {
    store.wholeCore.value = "missing";
  }
}

/** Asks the whole core whenever there is a text that only it may read. */
export function readOnWhereNeeded(store: Store) {
  effect(() => {
    if (store.mayBeRead.value) readOn(store);
  });
}
