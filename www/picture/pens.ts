// How each kind of line is drawn, and how much a label stays off it; colours follow the theme.

export interface Pen {
  colour: string;
  width: number;
  dash?: string;
  opacity?: number;
  /** Against a label on it. */
  weight: number;
  /** Nearer to the eye than it is by so much, so that of two lines on each other the strong one shows. */
  nearness: number;
}

const axisPens = (kind: string, pen: Omit<Pen, "colour">): [string, Pen][] =>
  ["x", "y", "z"].map((letter) => [
    `${kind}-${letter}`,
    { colour: `var(--axis-${letter})`, ...pen },
  ]);

const pens: Record<string, Pen> = {
  ...Object.fromEntries([
    ...axisPens("world", { width: 1.25, weight: 0.9, nearness: 0.2 }),
    ...axisPens("body", { width: 3.2, weight: 1.2, nearness: 0.6 }),
    ...axisPens("ghost", { width: 1.6, dash: "2 3", weight: 0.7, nearness: 0.4 }),
  ]),
  ghost: { colour: "var(--picture-soft)", width: 1, dash: "3 2.5", weight: 0.1, nearness: 0 },
  ground: { colour: "var(--picture-soft)", width: 0.8, opacity: 0.45, weight: 0.06, nearness: 0 },
  turn: { colour: "var(--picture-ink)", width: 1.4, weight: 1, nearness: 0 },
  "turn-axis": { colour: "var(--picture-ink)", width: 1, dash: "4 3", weight: 0.5, nearness: 0 },
  before: { colour: "var(--picture-accent)", width: 1.4, weight: 1, nearness: 0.6 },
  after: { colour: "var(--picture-accent)", width: 3, weight: 1.2, nearness: 0.8 },
  way: { colour: "var(--picture-accent)", width: 1.2, dash: "1 2.5", weight: 0.2, nearness: 0 },
};
const plainPen: Pen = { colour: "var(--picture-ink)", width: 1, weight: 0.2, nearness: 0 };

export const penOf = (name: string): Pen => pens[name] ?? plainPen;
/** Of the body's edges and diagonals. */
export const bodyWeight = 0.12;
