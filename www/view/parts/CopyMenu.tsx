// The formats in which a value can be copied, each with its first line. Loaded when it is opened.
import { useRef } from "preact/hooks";
import { originOf, preview } from "../../copy/code.ts";
import type { Copied } from "../../model/copied.ts";
import { canSay, type Format, formats } from "../../model/copy_formats.ts";
import { chooseFormat } from "../../state/copy_format.ts";
import { copyWords, formatNames } from "../../words/parts/copy.ts";
import { focusAnchor, Popup } from "./Popup.tsx";
import "./copy_menu.css";

export interface MenuProps {
  of: string;
  text: string;
  value: Copied;
  chosen: Format;
  anchor: HTMLElement;
  copy: (format: Format) => void;
  close: () => void;
}

/** Letters typed in quick succession are one word. */
const wordMs = 600;

export function CopyMenu({ of, text, value, chosen, anchor, copy, close }: MenuProps) {
  const typed = useRef({ word: "", at: 0 });
  const origin = originOf(anchor);

  const choose = (format: Format) => {
    chooseFormat(format);
    // First the focus, so that a browser that asks before copying asks for the page.
    focusAnchor(anchor);
    copy(format);
    close();
  };
  const onKeyDown = (event: KeyboardEvent, menu: HTMLElement) => {
    const items = [...menu.querySelectorAll<HTMLElement>("[role=menuitemradio]")];
    const now = items.indexOf(document.activeElement as HTMLElement);
    const next = nextItem(event, items, now, typed.current);
    if (next === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    items.at(next % items.length)?.focus();
  };

  return (
    <Popup
      anchor={anchor}
      close={close}
      role="menu"
      label={copyWords.menu(of)}
      kind="copy-menu"
      onKeyDown={onKeyDown}
    >
      {formats
        .filter(({ id }) => canSay(id, value))
        .map(({ id }) => (
          <button
            key={id}
            type="button"
            role="menuitemradio"
            aria-checked={id === chosen}
            aria-label={formatNames[id]}
            tabIndex={id === chosen ? 0 : -1}
            onClick={() => choose(id)}
          >
            <span class="copy-format">{formatNames[id]}</span>
            <code>{id === "numbers" ? text : preview(value, id, origin)}</code>
          </button>
        ))}
    </Popup>
  );
}

/** The item that a key leads to; nothing for a key that leads nowhere. */
function nextItem(
  { key, ctrlKey, metaKey, altKey }: KeyboardEvent,
  items: HTMLElement[],
  now: number,
  typed: { word: string; at: number },
): number | undefined {
  switch (key) {
    case "ArrowDown":
      return now + 1;
    case "ArrowUp":
      return now - 1;
    case "Home":
      return 0;
    case "End":
      return items.length - 1;
  }
  if (key.length !== 1 || key === " " || ctrlKey || metaKey || altKey) return undefined;
  const time = Date.now();
  const isGoingOn = time - typed.at < wordMs;
  typed.word = (isGoingOn ? typed.word : "") + key.toLowerCase();
  typed.at = time;
  // A first letter leads to the next item that begins so, or has a word that does.
  const start = isGoingOn && typed.word.length > 1 ? now : now + 1;
  const found = [...items.keys()]
    .map((step) => (start + step) % items.length)
    .find((at) =>
      ` ${items[at]?.getAttribute("aria-label")?.toLowerCase()}`.includes(` ${typed.word}`),
    );
  return found ?? now;
}
