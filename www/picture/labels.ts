// Labels that would stand on each other, moved apart; pure.
import { type OnPaper, paper } from "./camera.ts";

const lineHeight = 16;
const letterWidth = 9;
const margin = 12;

interface Placeable {
  label: { text: string; frame?: string };
  at: OnPaper;
}

const halfWidth = ({ label: { text, frame = "" } }: Placeable) =>
  ((text.length + frame.length * 0.7) * letterWidth) / 2;

/** The same labels, none on one before it, and all of them on the paper. */
export function apart<Placed extends Placeable>(labels: readonly Placed[]): Placed[] {
  const placed: Placed[] = [];
  for (const label of labels) {
    const half = halfWidth(label);
    let across = within(label.at.across, paper.width);
    let down = within(label.at.down, paper.height);
    for (const other of placed) {
      const [x, y] = [across - other.at.across, down - other.at.down];
      const overlap = half + halfWidth(other) - Math.abs(x);
      if (overlap <= 0 || Math.abs(y) >= lineHeight) continue;
      // The shorter way out: to the side where they are nearly beside each other, else up or down.
      if (overlap < lineHeight - Math.abs(y)) across += x < 0 ? -overlap : overlap;
      else if (y < 0 && other.at.down - lineHeight > margin) down = other.at.down - lineHeight;
      else down = other.at.down + lineHeight;
    }
    placed.push({ ...label, at: { depth: label.at.depth, across, down } });
  }
  return placed;
}

const within = (place: number, size: number) => Math.min(size - margin, Math.max(margin, place));
