// What goes wrong with a small turn and with a rate.
import type { MistakeKind } from "../../engine.ts";

export const mistakeWords: Partial<Record<MistakeKind, string>> = {
  "other-side": "on the other side",
  "other-sign": "with the other sign",
  "half-forgotten": "without the half",
  "degrees-as-radians": "degrees taken as radians",
};
