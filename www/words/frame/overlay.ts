// The dialogs over the page.
import type { OverlayName } from "../../model/overlay_name.ts";

export const overlayNames: Record<OverlayName, string> = {
  help: "Keyboard shortcuts",
  gallery: "Examples",
};

export const close = "Close";
export const loading = "Loading …";
export const notLoaded = "This part of the page could not be loaded. Reload the page to try again.";
