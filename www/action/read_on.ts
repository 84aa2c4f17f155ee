// What the core of the first load cannot read is read by the whole one.
import { effect } from "@preact/signals";
import { inPlace } from "../dom/hold.ts";
import type { Store } from "../state/store.ts";
import { loadWhole } from "./whole_core.ts";

/** Answers with the whole core from now on, once it is there. It never throws. */
export async function readOn(store: Store) {
  store.wholeCore.value = "awaited";
  const engine = await loadWhole().catch(() => undefined);
  inEditedPlace(() => {
    if (engine) store.useEngine(engine);
    else store.wholeCore.value = "missing";
  });
}

/** Whatever is said now of a number that is being edited, the number stays where it is. */
function inEditedPlace(answer: () => void) {
  const field = document.activeElement;
  if (field instanceof HTMLInputElement && field.type === "text") inPlace(field, answer);
  else answer();
}

/** Asks the whole core whenever there is a text that only it may read. */
export function readOnWhereNeeded(store: Store) {
  effect(() => {
    if (store.mayBeRead.value) readOn(store);
  });
}

/** Resolves once it is known what the texts are. */
export async function read(store: Store) {
  if (!store.isReading.peek()) return;
  await new Promise<void>((done) => {
    const stop = store.isReading.subscribe((isReading) => {
      if (isReading) return;
      done();
      stop();
    });
  });
}
