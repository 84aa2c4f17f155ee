// Whose keys the visitor has. At first nobody's in particular, as the page was rendered before.
import { signal } from "@preact/signals";

export const isMac = signal(false);

export function lookAtPlatform() {
  isMac.value = /Mac|iPhone|iPad/.test(navigator.platform);
}
