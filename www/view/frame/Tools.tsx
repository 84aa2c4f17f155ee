// What each visitor chooses for himself: decimals, the unit of angles, the theme.
import type { ComponentChildren } from "preact";
import type { Theme } from "../../model/settings.ts";
import { showOverlay } from "../../state/overlay.ts";
import { chooseTheme, nextTheme, theme } from "../../state/settings.ts";
import { overlayNames } from "../../words/frame/overlay.ts";
import { isNow, themeLabel, themeWords } from "../../words/settings.ts";
import "./tools.css";

/** The tools beside the views: the theme, and the list of keys. */
export function Tools({ children }: { children: ComponentChildren }) {
  const themeName = isNow(themeLabel, themeWords[theme.value]);
  return (
    <div class="tools">
      {children}
      <button type="button" class="tool" title={themeName} onClick={() => chooseTheme(nextTheme())}>
        <svg viewBox="0 0 16 16" width="16" height="16" aria-hidden="true">
          <path d={themePaths[theme.value]} />
          {theme.value === "system" && <path class="tool-full" d="M8 2 a6 6 0 0 0 0 12 z" />}
        </svg>
        <span class="visually-hidden">{themeName}</span>
      </button>
      <button
        type="button"
        class="tool"
        title={overlayNames.help}
        aria-haspopup="dialog"
        onClick={() => showOverlay("help")}
      >
        <span aria-hidden="true">?</span>
        <span class="visually-hidden">{overlayNames.help}</span>
      </button>
    </div>
  );
}

/** A disc, of which half is filled besides; a sun; a moon. */
const themePaths: Record<Theme, string> = {
  system: "M8 2 a6 6 0 0 0 0 12 a6 6 0 0 0 0 -12 z",
  light:
    "M8 5 a3 3 0 0 1 0 6 a3 3 0 0 1 0 -6 z M8 1 v1.5 M8 13.5 v1.5 M1 8 h1.5 M13.5 8 h1.5 M3 3 l1.1 1.1 M11.9 11.9 l1.1 1.1 M13 3 l-1.1 1.1 M4.1 11.9 L3 13",
  dark: "M6.5 2 a6 6 0 1 0 7.5 7.5 a5 5 0 0 1 -7.5 -7.5 z",
};
