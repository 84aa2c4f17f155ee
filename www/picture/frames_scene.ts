// Frames where they stand, as large as the picture allows; pure.
import type { FramesReport } from "../engine.ts";
import { axesOf, ground, type Scene, scene } from "./scene.ts";
import { minus, origin, plus, times, type Vector } from "./space.ts";

/** How far from the middle the outermost frame stands, and how long an axis is. */
const reach = 1.4;
const axisLength = 0.4;

const standing = { w: 1, x: 0, y: 0, z: 0 };
const letters = ["x", "y", "z"] as const;

/** Each frame that is joined to the first with its axes, and a line along each pose that is known. */
export function framesScene({ frames, path }: FramesReport): Scene {
  const placed = frames.flatMap(({ name, matrix, origin: at }) =>
    matrix ? [{ name, matrix, at: (at ?? origin) as Vector }] : [],
  );
  const [low, high] = [Math.min, Math.max].map((most) =>
    [0, 1, 2].map((axis) => most(...placed.map(({ at }) => at[axis] ?? 0))),
  ) as unknown as [Vector, Vector];
  const middle = times(plus(low, high), 0.5);
  const size = Math.max(...placed.map(({ at }) => Math.hypot(...minus(at, middle))), 0);
  const scale = size > 0 ? reach / size : 1;
  const onStage = (at: Vector) => times(minus(at, middle), scale);
  const parts: Pick<Scene, "lines" | "labels">[] = [];
  if (size === 0) parts.push({ lines: ground(), labels: [] });
  for (const { name, matrix, at } of placed) {
    const here = onStage(at);
    const axes = axesOf(standing, 1, "body", "");
    const ends = letters.map((_, column) =>
      plus(here, times(matrix.map((row) => row[column] ?? 0) as unknown as Vector, axisLength)),
    );
    parts.push({
      lines: axes.lines.map((line, column) => ({ ...line, from: here, to: ends[column] ?? here })),
      labels: [{ tip: here, from: plus(here, [0, 0, 0.01]), text: name, pen: "turn" }],
    });
  }
  let before = frames[0];
  for (const { frame } of path) {
    const after = frames[frame];
    if (before?.origin && after?.origin) {
      const [from, to] = [onStage(before.origin), onStage(after.origin)];
      parts.push({ lines: [{ from, to, pen: "way", tip: "arrow" }], labels: [] });
    }
    before = after;
  }
  return { ...scene(standing, parts), isBare: true };
}
