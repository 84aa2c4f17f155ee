// The button that copies a value with all its digits, and the one beside it that offers formats.
import type { ComponentType } from "preact";
import { useRef, useState } from "preact/hooks";
import { putOnClipboard } from "../../dom/clipboard.ts";
import type { Copied } from "../../model/copied.ts";
import { canSay, type Format } from "../../model/copy_formats.ts";
import { announceVisibly } from "../../state/announcement.ts";
import { chosenFormat } from "../../state/copy_format.ts";
import { copyWords } from "../../words/parts/copy.ts";
import type { MenuProps } from "./CopyMenu.tsx";
import "./copy.css";

const copiedForMs = 1600;

/** Copies the exact text of a value, or the value as code, and says so. */
export function Copy({
  of,
  text,
  value,
}: {
  of: string;
  /** The value as numbers. */
  text: string;
  /** What the value is, where it can be said as code. */
  value?: Copied | undefined;
}) {
  const [isCopied, setCopied] = useState(false);
  const [Menu, setMenu] = useState<ComponentType<MenuProps>>();
  const button = useRef<HTMLButtonElement>(null);
  const more = useRef<HTMLButtonElement>(null);

  const copy = async (format: Format) => {
    const isAllowed = await putOnClipboard(
      value === undefined || format === "numbers"
        ? text
        : import("../../copy/code.ts").then(({ written, originOf }) =>
            written(value, format, originOf(button.current)),
          ),
    );
    announceVisibly(isAllowed ? copyWords.copied(of, format) : copyWords.notAllowed(of));
    if (!isAllowed) return;
    setCopied(true);
    setTimeout(() => setCopied(false), copiedForMs);
  };
  const open = async () => {
    const { CopyMenu } = await import("./CopyMenu.tsx");
    setMenu(() => CopyMenu);
  };

  const chosen = chosenFormat();
  const format = value !== undefined && canSay(chosen, value) ? chosen : "numbers";
  const name = copyWords.copy(of, format);
  return (
    <span class="copies">
      <button
        ref={button}
        type="button"
        class="copy"
        aria-label={name}
        title={format === "numbers" ? text : name}
        onClick={() => copy(format)}
      >
        <svg viewBox="0 0 16 16" width="14" height="14" aria-hidden="true">
          {isCopied ? (
            <path d="M3 8.5 L6.5 12 L13 4.5" />
          ) : (
            <path d="M5.5 5.5 h7 v8 h-7 z M10.5 5.5 v-3 h-7 v8 h2" />
          )}
        </svg>
      </button>
      {value !== undefined && (
        <button
          ref={more}
          type="button"
          class="copy copy-more"
          aria-label={copyWords.choose(of)}
          aria-haspopup="menu"
          aria-expanded={Menu !== undefined}
          onClick={() => (Menu === undefined ? open() : setMenu(undefined))}
          onKeyDown={(event) => {
            if (event.key !== "ArrowDown" && event.key !== "ArrowUp") return;
            event.preventDefault();
            open();
          }}
        >
          <svg viewBox="0 0 16 16" width="12" height="12" aria-hidden="true">
            <path d="M4 6.5 L8 10.5 L12 6.5" />
          </svg>
        </button>
      )}
      {value !== undefined && Menu !== undefined && more.current !== null && (
        <Menu
          of={of}
          text={text}
          value={value}
          chosen={format}
          anchor={more.current}
          copy={copy}
          close={() => setMenu(undefined)}
        />
      )}
    </span>
  );
}
