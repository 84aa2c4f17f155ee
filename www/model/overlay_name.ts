// The dialogs over the page.

export type OverlayName = "help" | "gallery";
