// One tab stop for many things in rows: the arrow keys lead from one to the next; pure.

/** Things in rows of the same length. */
export interface Rows {
  count: number;
  /** How many stand in a row; all of them in a list, whose arrows lead both ways. */
  columns: number;
}

/** Where a key leads from a place, which is the place itself at an end; nothing for other keys. */
export function placeAfter(
  { key, ctrlKey, shiftKey, altKey, metaKey }: KeyboardEvent,
  at: number,
  { count, columns }: Rows,
): number | undefined {
  if (shiftKey || altKey || metaKey) return undefined;
  if (ctrlKey) return key === "Home" ? 0 : key === "End" ? count - 1 : undefined;
  const first = at - (at % columns);
  const last = first + columns - 1;
  const down = columns === count ? 1 : columns;
  const within = (place: number) => (place >= 0 && place < count ? place : at);
  switch (key) {
    case "ArrowLeft":
      return Math.max(first, at - 1);
    case "ArrowRight":
      return Math.min(last, at + 1);
    case "ArrowUp":
      return within(at - down);
    case "ArrowDown":
      return within(at + down);
    case "Home":
      return first;
    case "End":
      return last;
    default:
      return undefined;
  }
}
