// What the links say that carry a case to another view.
import type { CarryTarget } from "../../model/carried.ts";

export const carryWords: Record<CarryTarget, string> = {
  read: "Read this",
  compose: "Compose with this",
  translate: "Translate this",
};

/** For who hears one link of many: what it carries. */
export const carryLabel = (target: CarryTarget, of: string) => `${carryWords[target]}: ${of}`;
