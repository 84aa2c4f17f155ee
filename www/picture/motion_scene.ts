// A body on its way, and beside it the body that a mistake makes of it; pure.
import type { Camera } from "./camera.ts";
import type { Line } from "./occlusion.ts";
import { bodyAxes, ground, outline, type Scene, scene, worldAxes } from "./scene.ts";
import { ofNormOne, type Quaternion, times, turned } from "./space.ts";

export type Way = readonly (readonly number[])[];

/** As many pieces of a way as can be told apart. */
const mostPieces = 80;
const reach = 1.22;

/** The attitude between two moments; their signs go on from one to the next. */
export function poseAt(way: Way, moment: number): Quaternion {
  const before = way[Math.floor(moment)] ?? [];
  const after = way[Math.ceil(moment)] ?? before;
  const part = moment - Math.floor(moment);
  const [w = 1, x = 0, y = 0, z = 0] = before
    .slice(1)
    .map((number, at) => number + part * ((after[at + 1] ?? number) - number));
  return ofNormOne({ w, x, y, z });
}

/** The way of the tip of the body's x axis up to a moment. */
function wayOfTip(way: Way, moment: number): Line[] {
  const pieces = Math.min(mostPieces, Math.ceil(moment));
  const points = Array.from({ length: pieces + 1 }, (_, at) =>
    times(turned([1, 0, 0], poseAt(way, (moment * at) / Math.max(1, pieces))), reach),
  );
  return points.slice(1).map((to, at) => ({ from: points[at] ?? to, to, pen: "way" }));
}

export function motionScene(
  way: Way,
  mistaken: Way | undefined,
  moment: number,
  camera: Camera,
): Scene {
  const pose = poseAt(way, moment);
  const parts: Pick<Scene, "lines" | "labels">[] = [
    { lines: ground(), labels: [] },
    worldAxes(),
    bodyAxes(pose, "B"),
    { lines: wayOfTip(way, moment), labels: [] },
  ];
  if (mistaken) parts.push(outline(poseAt(mistaken, moment), camera, "B′"));
  return scene(pose, parts);
}
