// Labels that would stand on each other, moved apart; pure.
import { type OnPaper, paper } from "./camera.ts";

const closest = 17;
const margin = 12;

/** The same labels, each at least a letter's width from those before it, and inside the paper. */
export function apart<Placed extends { at: OnPaper }>(labels: readonly Placed[]): Placed[] {
  const placed: Placed[] = [];
  for (const label of labels) {
    let { across, down } = label.at;
    for (const other of placed) {
      const [x, y] = [across - other.at.across, down - other.at.down];
      const distance = Math.hypot(x, y);
      if (distance >= closest) continue;
      // Straight down where they stand on the same point.
      const [u, v] = distance > 0.5 ? [x / distance, y / distance] : [0, 1];
      across = other.at.across + u * closest;
      down = other.at.down + v * closest;
    }
    const at = {
      depth: label.at.depth,
      across: Math.min(paper.width - margin, Math.max(margin, across)),
      down: Math.min(paper.height - margin, Math.max(margin, down)),
    };
    placed.push({ ...label, at });
  }
  return placed;
}
