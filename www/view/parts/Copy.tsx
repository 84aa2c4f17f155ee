// The button that copies a value with all its digits, and the one beside it that offers formats.
import type { ComponentType } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";
import { putOnClipboard } from "../../dom/clipboard.ts";
import type { Copied } from "../../model/copied.ts";
import { canSay, type Format } from "../../model/copy_formats.ts";
import { announceVisibly } from "../../state/announcement.ts";
import { chosenFormat } from "../../state/copy_format.ts";
import { copyWords } from "../../words/parts/copy.ts";
import type { MenuProps } from "./CopyMenu.tsx";
import "./copy.css";

const copiedForMs = 1600;

interface Value {
  of: string;
  /** The value as numbers. */
  text: string;
  /** What the value is, where it can be said as code. */
  value?: Copied | undefined;
}

/** The format in which a value is copied: the chosen one where it can say it. */
function formatOf(value: Copied | undefined): Format {
  const chosen = chosenFormat();
  return value !== undefined && canSay(chosen, value) ? chosen : "numbers";
}

/** Copies the exact text of a value, or the value as code, and says so. */
export function Copy({ face = "icon", ...copied }: Value & { face?: "icon" | "words" }) {
  const { of, text, value } = copied;
  const [isCopied, setCopied] = useState(false);
  const [Menu, setMenu] = useState<ComponentType<MenuProps>>();
  const frame = useRef<HTMLSpanElement>(null);

  const copy = async (format: Format) => {
    const isAllowed = await putOnClipboard(
      value === undefined || format === "numbers"
        ? text
        : import("../../copy/code.ts").then(({ written, originOf }) =>
            written(value, format, originOf(frame.current)),
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

  const format = formatOf(value);
  const name = copyWords.copy(of, format);
  return (
    <span ref={frame} class={`copies copies-${face}`}>
      <button
        type="button"
        class="copy"
        aria-label={name}
        aria-keyshortcuts={value && copyWords.formatsKey}
        title={format === "numbers" ? text : name}
        onClick={() => copy(format)}
        onKeyDown={(event) => {
          if (value === undefined) return;
          if (event.key !== "ArrowDown" && event.key !== "ArrowUp") return;
          event.preventDefault();
          open();
        }}
      >
        <svg viewBox="0 0 16 16" width="14" height="14" aria-hidden="true">
          {isCopied ? (
            <path d="M3 8.5 L6.5 12 L13 4.5" />
          ) : (
            <path d="M5.5 5.5 h7 v8 h-7 z M10.5 5.5 v-3 h-7 v8 h2" />
          )}
        </svg>
        {face === "words" && <span>{copyWords.as(format)}</span>}
      </button>
      {value !== undefined && (
        <button
          type="button"
          class="copy copy-more"
          // The arrow keys open it from the button beside it: a value is one stop of the Tab key.
          tabIndex={-1}
          aria-label={copyWords.choose(of)}
          aria-haspopup="menu"
          aria-expanded={Menu !== undefined}
          onClick={() => (Menu === undefined ? open() : setMenu(undefined))}
        >
          <svg viewBox="0 0 16 16" width="12" height="12" aria-hidden="true">
            <path d="M4 6.5 L8 10.5 L12 6.5" />
          </svg>
        </button>
      )}
      {value !== undefined && Menu !== undefined && frame.current !== null && (
        <Menu
          of={of}
          text={text}
          value={value}
          chosen={format}
          anchor={frame.current}
          copy={copy}
          close={() => setMenu(undefined)}
        />
      )}
    </span>
  );
}

/** The line that is copied, as numbers or as code, and the button that copies it. */
export function CopyLine(copied: Value) {
  const { text, value } = copied;
  const format = formatOf(value);
  const frame = useRef<HTMLDivElement>(null);
  const [code, setCode] = useState<typeof import("../../copy/code.ts")>();
  useEffect(() => {
    if (format !== "numbers") import("../../copy/code.ts").then(setCode, () => undefined);
  }, [format]);
  const line =
    value === undefined || format === "numbers"
      ? text
      : code?.preview(value, format, code.originOf(frame.current));
  return (
    <div class="copy-line" ref={frame}>
      <code title={line}>{line}</code>
      <Copy {...copied} face="words" />
    </div>
  );
}
