// A panel in front of the page, beside the button that opens it.
import type { ComponentChildren } from "preact";
import { useLayoutEffect, useRef } from "preact/hooks";
import { placeBeside } from "../../dom/place.ts";
import "./popup.css";

/**
 * It closes when something outside is pressed or gets the focus, when the page scrolls or changes
 * its size, and by Escape, which gives the focus back to the button, or to the first of several.
 */
export function Popup({
  anchor,
  close,
  children,
  role,
  label,
  kind,
  onKeyDown,
}: {
  anchor: HTMLElement;
  close: () => void;
  children: ComponentChildren;
  role: "menu" | "dialog";
  label: string;
  /** Its class. */
  kind: string;
  onKeyDown?: (event: KeyboardEvent, panel: HTMLElement) => void;
}) {
  const panel = useRef<HTMLDivElement>(null);
  useLayoutEffect(() => {
    const element = panel.current;
    if (element === null) return;
    // In the top layer nothing of the page covers or cuts it; older browsers show it as it is.
    element.showPopover?.();
    placeBeside(element, anchor);
    const chosen = element.querySelector<HTMLElement>("[aria-checked=true]");
    (chosen ?? element.querySelector<HTMLElement>("button"))?.focus({ preventScroll: true });
    chosen?.scrollIntoView({ block: "nearest" });
  }, [anchor]);

  // Before the next paint, so that no key is lost that follows at once.
  useLayoutEffect(() => {
    const element = panel.current;
    if (element === null) return;
    const closeOutside = (event: Event) => {
      const target = event.target as Node;
      if (!element.contains(target) && !anchor.contains(target)) close();
    };
    const onKey = (event: KeyboardEvent) => {
      onKeyDown?.(event, element);
      // A menu has one place in the order of the Tab key: that of its button.
      const isLeaving = event.key === "Escape" || (event.key === "Tab" && role === "menu");
      if (!isLeaving) return;
      if (event.key === "Escape") event.preventDefault();
      event.stopPropagation();
      focusAnchor(anchor);
      close();
    };
    const outside = ["pointerdown", "focusin", "scroll"];
    for (const name of outside) addEventListener(name, closeOutside, { capture: true });
    addEventListener("resize", close);
    element.addEventListener("keydown", onKey);
    return () => {
      for (const name of outside) removeEventListener(name, closeOutside, { capture: true });
      removeEventListener("resize", close);
      element.removeEventListener("keydown", onKey);
    };
  });

  const named = { role, "aria-label": label };
  return (
    <div ref={panel} {...named} class={`popup ${kind}`} popover="manual">
      {children}
    </div>
  );
}

/** Gives the focus back to the button that opened it, or to the first of the buttons that are the anchor. */
export function focusAnchor(anchor: HTMLElement) {
  (anchor.matches("button") ? anchor : anchor.querySelector("button"))?.focus();
}
