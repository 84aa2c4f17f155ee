// What hides what: lines before and behind one convex solid; pure.
//
// The solid is convex, so a piece of a line that lies outside one of its sides cannot be hidden by
// it where the eye is outside that side too, and cannot hide it where the eye is not. No sorting of
// sides is needed: those that face away from the eye are not drawn, and the others do not overlap.
import { type Camera, type OnPaper, onPaper } from "./camera.ts";
import { penOf } from "./pens.ts";
import { type Face, faces } from "./solid.ts";
import { between, dot, minus, plus, type Quaternion, times, turned, type Vector } from "./space.ts";

export interface Line {
  from: Vector;
  to: Vector;
  /** Which pen draws it. */
  pen: string;
  /** An arrow tip at its end. */
  tip?: "arrow";
}

export interface PaintedLine {
  from: OnPaper;
  to: OnPaper;
  pen: string;
  tip?: "arrow";
}

/** A side of the solid as it stands in space. */
export interface Plane {
  normal: Vector;
  /** How far from the origin along its normal. */
  offset: number;
  isFacing: boolean;
  face: Face;
}

export function planesOf(pose: Quaternion, camera: Camera): Plane[] {
  return faces.map((face) => {
    const normal = turned(face.normal, pose);
    const offset = dot(face.normal, face.corners[0] ?? face.normal);
    return { normal, offset, isFacing: dot(normal, camera.eye) > offset, face };
  });
}

type Place = "before" | "behind" | "inside";

function placeOf(point: Vector, planes: readonly Plane[]): Place {
  const outside = planes.filter(({ normal, offset }) => dot(normal, point) > offset);
  // Where there is no solid nothing is hidden.
  if (outside.length === 0) return planes.length === 0 ? "before" : "inside";
  return outside.some(({ isFacing }) => isFacing) ? "before" : "behind";
}

/** Where a line crosses the sides, as parts of its length, from 0 to 1. */
function crossings({ from, to }: Line, planes: readonly Plane[]): number[] {
  const along = minus(to, from);
  const inner = planes
    .map(({ normal, offset }) => (offset - dot(normal, from)) / dot(normal, along))
    .filter((part) => part > 0 && part < 1);
  return [0, ...inner.sort((a, b) => a - b), 1];
}

/** The pieces of lines that are behind the solid and before it, the far ones first. */
export function painted(lines: readonly Line[], planes: readonly Plane[], camera: Camera) {
  const lists: Record<Place, PaintedLine[]> = { before: [], behind: [], inside: [] };
  for (const line of lines) {
    const parts = crossings(line, planes);
    let start = 0;
    for (let at = 1; at < parts.length; at += 1) {
      const end = parts[at] ?? 1;
      const place = placeOf(between(line.from, line.to, ((parts[at - 1] ?? 0) + end) / 2), planes);
      const next = parts[at + 1];
      const isLast = next === undefined;
      if (!isLast && placeOf(between(line.from, line.to, (end + next) / 2), planes) === place) {
        continue;
      }
      lists[place].push({
        from: onPaper(between(line.from, line.to, start), camera),
        to: onPaper(between(line.from, line.to, end), camera),
        pen: line.pen,
        ...(isLast && line.tip ? { tip: line.tip } : {}),
      });
      start = end;
    }
  }
  const nearness = ({ from, to, pen }: PaintedLine) => penOf(pen).nearness - from.depth - to.depth;
  const farFirst = (a: PaintedLine, b: PaintedLine) => nearness(a) - nearness(b);
  return { behind: lists.behind.sort(farFirst), before: lists.before.sort(farFirst) };
}

/** Whether the solid stands between a point and the eye. */
export function isHidden(point: Vector, planes: readonly Plane[], camera: Camera): boolean {
  const parts = crossings({ from: point, to: camera.eye, pen: "" }, planes);
  return parts.slice(1).some((end, at) => {
    const middle = ((parts[at] ?? 0) + end) / 2;
    return placeOf(between(point, camera.eye, middle), planes) === "inside";
  });
}

/** The edges of the solid in a pose that the eye can see, as lines of one pen. */
export function visibleEdges(pose: Quaternion, camera: Camera, pen: string): Line[] {
  const seen = new Set<string>();
  return planesOf(pose, camera)
    .filter(({ isFacing }) => isFacing)
    .flatMap(({ face: { corners } }) =>
      corners.flatMap((corner, at) => {
        const next = corners[(at + 1) % corners.length] ?? corner;
        const middle = times(plus(corner, next), 0.5).join(" ");
        if (seen.has(middle)) return [];
        seen.add(middle);
        return [{ from: turned(corner, pose), to: turned(next, pose), pen }];
      }),
    );
}
