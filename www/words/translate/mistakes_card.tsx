// What goes wrong in a translation.
import type { ComponentChildren } from "preact";
import type { MistakeKind, TranslateReport } from "../../engine.ts";

export const title = "What goes wrong with these numbers";
export const none = "no difference with these numbers; others show the mistake";
export const off = (angle: ComponentChildren) => <>{angle} off</>;

const mistakeWords: Partial<Record<MistakeKind, string>> = {
  copied: "copied as they are",
  "not-reordered": "not reordered",
  "not-conjugated": "not conjugated",
  "conjugated-needlessly": "conjugated needlessly",
  "constructor-order": "passed to the constructor as the array stands",
  "axes-kept": "axes not changed",
};

/** A mistake; where two things are to be done, one of them may be done and the other not. */
export function mistakeOf(kind: MistakeKind, change: TranslateReport["change"]): string {
  if (change === "reordered-and-conjugated") {
    if (kind === "not-reordered") return "conjugated, but not reordered";
    if (kind === "not-conjugated") return "reordered, but not conjugated";
  }
  return mistakeWords[kind] ?? kind;
}
