// The labels of a scene and where they stand; pure.
import { type Camera, onPaper } from "./camera.ts";
import { type Obstacle, type Place, placed, type Stood, widthOf } from "./labels.ts";
import { isHidden, type PaintedLine, type Plane } from "./occlusion.ts";
import { bodyWeight, penOf } from "./pens.ts";
import type { Label, Scene } from "./scene.ts";
import { type Quaternion, turned } from "./space.ts";

export interface Lettered {
  label: Label;
  place: Place;
  width: number;
  isHidden: boolean;
}

/**
 * The labels, each with its place. `last` holds where those of the drawing before this one stood, by their
 * keys, and then where these stand.
 */
export function lettered(
  { labels, pose }: Scene,
  camera: Camera,
  planes: readonly Plane[],
  lines: readonly PaintedLine[],
  last: Map<string, Stood>,
): Lettered[] {
  const placeable = labels.map(({ tip, from, text, frame = "", pen }) => ({
    key: `${pen} ${frame}`,
    tip: onPaper(tip, camera),
    from: onPaper(from, camera),
    width: widthOf(text, frame),
  }));
  const obstacles = [
    ...lines.map(({ from, to, pen }) => ({ from, to, weight: penOf(pen).weight })),
    ...linesOfBody(pose, planes, camera),
  ];
  const places = placed(placeable, obstacles, camera.paper, last);
  last.clear();
  return labels.flatMap((label, at) => {
    const [own, place] = [placeable[at], places[at]];
    if (own === undefined || place === undefined) return [];
    const { key, tip, width } = own;
    last.set(key, { ...place, tip });
    return [{ label, place, width, isHidden: isHidden(label.tip, planes, camera) }];
  });
}

/** The edges of the sides that are seen, and their diagonals, so that a label stands rather beside the body. */
function linesOfBody(pose: Quaternion, planes: readonly Plane[], camera: Camera): Obstacle[] {
  return planes.flatMap(({ isFacing, face: { corners } }) => {
    if (!isFacing) return [];
    const points = corners.map((corner) => onPaper(turned(corner, pose), camera));
    return points.flatMap((from, at) =>
      points.slice(at + 1).map((to) => ({ from, to, weight: bodyWeight })),
    );
  });
}
