// Where labels stand: beyond the ends of their lines, on the paper, on no other label and on few lines; pure.
import type { OnPaper, Paper } from "./camera.ts";

/** What a label names, and how large it is written. */
export interface Placeable {
  /** The same for a label from one drawing to the next. */
  key: string;
  tip: OnPaper;
  from: OnPaper;
  width: number;
}

/** A line that a label stays off, the more the heavier it is. */
export interface Obstacle {
  from: OnPaper;
  to: OnPaper;
  weight: number;
}

/** The middle of a label. */
export interface Place {
  across: number;
  down: number;
}

/** Where a label stood, and the end of its line. */
export interface Stood extends Place {
  tip: Place;
}

interface Box extends Place {
  width: number;
}

/** Of a line of text, with what hangs below it. */
export const lineHeight = 23;
/** Of its letters alone. */
const inkHeight = 13;
export const fontSize = 16;
export const frameSize = 11;
/** Between a tip and its label. */
const gap = 5;

/** To both sides of the line, up to half a turn, and farther from its end where that is full; the best first. */
const ways = [0, 12, 26, 44, 70]
  .flatMap((beyond) =>
    Array.from({ length: 23 }, (_, at) => {
      const asideDeg = (at - 11) * 15;
      const cost = Math.abs(asideDeg) / 25 + beyond / 4;
      return { beyond, aside: (asideDeg * Math.PI) / 180, cost };
    }),
  )
  .sort((a, b) => a.cost - b.cost);
/** For each pixel that a label moves against its line, and at most. */
const [moving, mostMoving] = [0.4, 12];
/** A line whose end is farther from the last one was not dragged, and its label begins anew. */
const mostDragged = 40;
const overlapping = 1e4;

/** No narrower than any of the fonts for it writes it. */
export function widthOf(text: string, frame = ""): number {
  const ems = (letters: string) =>
    [...letters].reduce(
      (sum, letter) => sum + (wide[letter] ?? (/[.:°′, ]/.test(letter) ? 0.5 : 0.65)),
      0,
    );
  return ems(text) * fontSize + ems(frame) * frameSize;
}
const wide: Record<string, number> = { W: 1.05, H: 0.9, B: 0.75, "−": 0.85 };

/**
 * The places of labels, each the best when those before it have theirs. A place is measured from the end
 * of its line, so a label goes along with a line that turns. `last` has where the labels of the drawing
 * before stood, by their keys: another place is the dearer the farther it is, so that a label gives way in
 * small steps, and goes to another side only where that is clearly better: it does not waver.
 */
export function placed(
  labels: readonly Placeable[],
  obstacles: readonly Obstacle[],
  paper: Paper,
  last: ReadonlyMap<string, Stood>,
): Place[] {
  const boxes: Box[] = [];
  for (const { key, tip, from, width } of labels) {
    const stood = last.get(key);
    const before = stood && distance(stood.tip, tip) < mostDragged ? stood : undefined;
    const near = obstacles.filter((line) => isNear(line, tip, width / 2 + 60));
    let best: Box = { across: tip.across, down: tip.down, width };
    let least = Number.POSITIVE_INFINITY;
    for (const { aside, beyond, cost } of ways) {
      if (cost >= least) break;
      const free = beside(tip, from, aside, beyond + gap, width);
      const box = within(free, paper);
      let sum = cost + distance(box, free) / 4;
      if (before) {
        const along = {
          across: before.across + tip.across - before.tip.across,
          down: before.down + tip.down - before.tip.down,
        };
        sum += Math.min(mostMoving, distance(box, along) * moving);
      }
      for (const other of boxes) sum += overlapping * overlap(box, other);
      for (const { from, to, weight } of near) {
        if (sum >= least) break;
        sum += weight * lengthIn(from, to, box);
      }
      if (sum < least) [least, best] = [sum, box];
    }
    boxes.push(best);
  }
  return boxes.map(({ across, down }) => ({ across, down }));
}

const distance = (one: Place, other: Place) =>
  Math.hypot(one.across - other.across, one.down - other.down);

/** The box that begins so far from the tip, in a direction so far to the side of the line. */
function beside(tip: OnPaper, from: OnPaper, aside: number, away: number, width: number): Box {
  const along = Math.atan2(tip.down - from.down, tip.across - from.across) + aside;
  const [right, below] = [Math.cos(along), Math.sin(along)];
  const radius = away + Math.hypot((right * width) / 2, (below * inkHeight) / 2);
  return { across: tip.across + right * radius, down: tip.down + below * radius, width };
}

function within({ across, down, width }: Box, paper: Paper): Box {
  const clamped = (place: number, half: number, size: number) =>
    Math.max(half, Math.min(size - half, place));
  return {
    across: clamped(across, width / 2 + 1, paper.width),
    down: clamped(down, lineHeight / 2, paper.height),
    width,
  };
}

/** How far two labels are in each other, in pixels the shorter way. */
function overlap(one: Box, other: Box) {
  const across = (one.width + other.width) / 2 + 1 - Math.abs(one.across - other.across);
  const down = lineHeight + 1 - Math.abs(one.down - other.down);
  return Math.max(0, Math.min(across, down));
}

function isNear({ from, to }: Obstacle, { across, down }: OnPaper, reach: number) {
  return (
    Math.min(from.across, to.across) < across + reach &&
    Math.max(from.across, to.across) > across - reach &&
    Math.min(from.down, to.down) < down + reach &&
    Math.max(from.down, to.down) > down - reach
  );
}

/** How much of a line is in the letters of a box, in pixels (Liang and Barsky's clipping). */
function lengthIn(from: OnPaper, to: OnPaper, { across, down, width }: Box): number {
  const [halfWidth, halfHeight] = [width / 2, inkHeight / 2];
  const [startAcross, startDown] = [from.across - across, from.down - down];
  const [dx, dy] = [to.across - from.across, to.down - from.down];
  // Where it passes the left and right edge, and the upper and lower one, as parts of its length; a
  // line along an edge passes it infinitely far away.
  const [left, right] = [(-halfWidth - startAcross) / dx, (halfWidth - startAcross) / dx];
  const [top, bottom] = [(-halfHeight - startDown) / dy, (halfHeight - startDown) / dy];
  const enters = Math.max(0, Math.min(left, right), Math.min(top, bottom));
  const leaves = Math.min(1, Math.max(left, right), Math.max(top, bottom));
  return leaves > enters ? (leaves - enters) * Math.hypot(dx, dy) : 0;
}
