// The button that copies a value with all its digits.
import { useState } from "preact/hooks";

const copiedForMs = 1600;

/** Copies the exact text of a value and says so. */
export function Copy({ of, text }: { of: string; text: string }) {
  const [said, setSaid] = useState<"" | "copied" | "not allowed">("");
  const copy = async () => {
    try {
      await navigator.clipboard.writeText(text);
      setSaid("copied");
    } catch {
      setSaid("not allowed");
    }
    setTimeout(() => setSaid(""), copiedForMs);
  };
  return (
    <button type="button" class="copy" onClick={copy} title={text}>
      <svg viewBox="0 0 16 16" width="14" height="14" aria-hidden="true">
        {said === "copied" ? (
          <path d="M3 8.5 L6.5 12 L13 4.5" />
        ) : (
          <path d="M5.5 5.5 h7 v8 h-7 z M10.5 5.5 v-3 h-7 v8 h2" />
        )}
      </svg>
      <span class="visually-hidden">{said === "" ? `Copy ${of}` : `${of} ${said}`}</span>
    </button>
  );
}
