// Which dialog stands over the page.
import { signal } from "@preact/signals";
import type { OverlayName } from "../model/overlay_name.ts";

/** One opening of a dialog: the same name opened again is another. */
export interface Overlay {
  name: OverlayName;
}

export const shownOverlay = signal<Overlay | undefined>(undefined);

export function showOverlay(name: OverlayName): undefined {
  shownOverlay.value = { name };
}

/**
 * Hides that opening. A dialog tells only later that it was closed, when the next may stand already:
 * it is no business of the one before.
 */
export function hideOverlay(overlay: Overlay) {
  if (shownOverlay.peek() === overlay) shownOverlay.value = undefined;
}
