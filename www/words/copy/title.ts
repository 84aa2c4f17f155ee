// The words of the title of the tab, which are those of a link to what it shows.
import type { ComponentOrder } from "../../engine.ts";
import type { Preset } from "../../model/page_state.ts";
import { lettersOf, wordsOf } from "../conventions.ts";

const ownOrder: Record<Preset, ComponentOrder> = {
  hamilton: "scalar-first",
  jpl: "scalar-last",
};

export const titleWords = {
  /** The order is said where it is not that of the name. */
  convention: (preset: Preset | undefined, order: ComponentOrder) => {
    const name = preset ? wordsOf[preset].name : "custom";
    return preset && ownOrder[preset] === order ? name : `${name} (${lettersOf[order]})`;
  },
  read: (turn: string, convention: string, numbers: string) => `${turn} · ${convention} ${numbers}`,
  compose: (product: string, numbers: string, convention: string) =>
    `${product} = ${numbers} · ${convention}`,
  translate: (from: string, to: string, numbers: string) => `${from} → ${to} · ${numbers}`,
  motion: (convention: string, numbers: string, rate: string) =>
    `${convention} ${numbers} · ω ${rate} rad/s`,
  part: (name: string, part: string) => `${name} · ${part}`,
  page: (shown: string) => `${shown} · quatlas`,
};
