// How words are put together in English.

/** `a`, `a and b`, `a, b and c`. */
export function listed(parts: readonly string[], word = "and"): string {
  const last = parts.at(-1) ?? "";
  return parts.length < 2 ? last : `${parts.slice(0, -1).join(", ")} ${word} ${last}`;
}

/** The numbers of things that are counted from 1. */
export const numbered = (places: readonly number[]) => listed(places.map((at) => String(at + 1)));

/** As a sentence begins. */
export const capital = (text: string) => text.charAt(0).toUpperCase() + text.slice(1);

/** In one piece where lines are broken. */
export const unbroken = (text: string) => text.replaceAll(" ", "\u00a0");
