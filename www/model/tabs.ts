// The tabs of the page, and the views that are the parts of each.
import type { View } from "./page_state.ts";

/** In their order; a tab opens on its first part. What comes is a line here, with its view. */
export const tabs = {
  read: ["read"],
  compose: ["compose"],
  motion: ["motion"],
  frames: ["frames"],
  libraries: ["translate", "identify", "libraries"],
} as const satisfies Record<string, readonly View[]>;

export type Tab = keyof typeof tabs;
export const tabNames = Object.keys(tabs) as Tab[];

export const partsOf = (tab: Tab): readonly View[] => tabs[tab];

/** The tab in which a view stands. */
export function tabOf(view: View): Tab {
  return tabNames.find((tab) => partsOf(tab).includes(view)) ?? "read";
}
