// Which dialog stands over the page.
import { signal } from "@preact/signals";
import type { OverlayName } from "../model/overlay_name.ts";

export const shownOverlay = signal<OverlayName | undefined>(undefined);

export function showOverlay(name: OverlayName): undefined {
  shownOverlay.value = name;
}

export function hideOverlay() {
  shownOverlay.value = undefined;
}
