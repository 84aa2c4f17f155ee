// What the picture shows, as lines and labels in space; pure.
import type { Camera } from "./camera.ts";
import { type Line, visibleEdges } from "./occlusion.ts";
import {
  acrossOf,
  directionOf,
  dot,
  minus,
  origin,
  plus,
  type Quaternion,
  times,
  turnAbout,
  turned,
  unitVectors,
  type Vector,
} from "./space.ts";

export interface Label {
  /** What it names: the end of a line. */
  tip: Vector;
  /** Where that line comes from: the label stands beyond the tip. */
  from: Vector;
  text: string;
  /** Stands below the line: the frame of an axis. */
  frame?: string;
  pen: string;
}

export interface Scene {
  /** No body stands at the origin. */
  isBare?: true;
  /** How the body stands in the world: carries world axes onto body axes. */
  pose: Quaternion;
  lines: Line[];
  labels: Label[];
}

export interface Turning {
  /** Of length 1. */
  axis: Vector;
  angleRad: number;
}

const letters = ["x", "y", "z"] as const;
const worldLength = 1.52;
const bodyLength = 1.22;
const vectorLength = 1.36;
const groundRadius = 1.22;
/** The axis of the turn: above the arc, and below the body. */
const axisReach = 1.32;
const axisDepth = 1.1;
const arcRadius = 0.4;
const arcHeight = 0.92;
/** One piece of a circle. */
const piece = Math.PI / 36;

/** The three axes of a frame with their letters. */
export function axesOf(
  pose: Quaternion,
  length: number,
  pens: "world" | "body" | "ghost",
  frame: string,
): Pick<Scene, "lines" | "labels"> {
  const ends = unitVectors.map((axis) => turned(axis, pose));
  return {
    lines: ends.map((end, at) => ({
      from: origin,
      to: times(end, length),
      pen: `${pens}-${letters[at]}`,
      tip: "arrow",
    })),
    labels: ends.map((end, at) => ({
      tip: times(end, length),
      from: origin,
      text: letters[at] ?? "",
      frame,
      pen: `${pens}-${letters[at]}`,
    })),
  };
}

const standing: Quaternion = { w: 1, x: 0, y: 0, z: 0 };

export const worldAxes = () => axesOf(standing, worldLength, "world", "W");
export const bodyAxes = (pose: Quaternion, frame: string) =>
  axesOf(pose, bodyLength, "body", frame);

/** The body as an outline, with its axes. */
export function outline(
  pose: Quaternion,
  camera: Camera,
  frame: string,
): Pick<Scene, "lines" | "labels"> {
  const axes = axesOf(pose, bodyLength - 0.12, "ghost", frame);
  return { lines: [...visibleEdges(pose, camera, "ghost"), ...axes.lines], labels: axes.labels };
}

/** A circle on the world's x-y plane, to stand on. */
export function ground(): Line[] {
  return arc([groundRadius, 0, 0], { axis: [0, 0, 1], angleRad: 2 * Math.PI }, "ground");
}

/** The way of a point about an axis through the origin. */
export function arc(start: Vector, { axis, angleRad }: Turning, pen: string): Line[] {
  const pieces = Math.max(1, Math.ceil(Math.abs(angleRad) / piece));
  const points = Array.from({ length: pieces + 1 }, (_, at) =>
    turned(start, turnAbout(axis, (angleRad * at) / pieces)),
  );
  return points.slice(1).map((to, at) => ({ from: points[at] ?? start, to, pen }));
}

function withTip(lines: Line[]): Line[] {
  return lines.map((line, at) => (at === lines.length - 1 ? { ...line, tip: "arrow" } : line));
}

/** The axis of a turn, and round its upper end an arc by its angle, on the side of the viewer. */
export function turningAxis(
  turning: Turning,
  angleWords: string,
  camera: Camera,
): Pick<Scene, "lines" | "labels"> {
  const { axis, angleRad } = turning;
  const towards = minus(camera.back, times(axis, dot(camera.back, axis)));
  const middle = directionOf(towards) ?? acrossOf(axis);
  const start = turned(times(middle, arcRadius), turnAbout(axis, -angleRad / 2));
  const up = times(axis, arcHeight);
  const end = turned(times(middle, arcRadius), turnAbout(axis, angleRad / 2));
  const round = withTip(arc(start, turning, "turn")).map((line) => ({
    ...line,
    from: plus(line.from, up),
    to: plus(line.to, up),
  }));
  return {
    lines: [
      { from: times(axis, -axisDepth), to: times(axis, axisReach), pen: "turn-axis" },
      ...round,
    ],
    labels: [{ tip: plus(end, up), from: up, text: angleWords, pen: "turn" }],
  };
}

/** A vector from the origin, drawn with one length whatever its own. */
export function vectorArrow(
  vector: Vector,
  text: string,
  pen: "before" | "after",
): Pick<Scene, "lines" | "labels"> {
  const direction = directionOf(vector);
  if (direction === undefined) return { lines: [], labels: [] };
  return {
    lines: [{ from: origin, to: times(direction, vectorLength), pen, tip: "arrow" }],
    labels: [{ tip: times(direction, vectorLength), from: origin, text, pen }],
  };
}

/** The way of the tip of a vector through a turn. */
export function wayOf(vector: Vector, turning: Turning): Line[] {
  const direction = directionOf(vector);
  if (direction === undefined) return [];
  return withTip(arc(times(direction, vectorLength * 0.8), turning, "way"));
}

export function scene(pose: Quaternion, parts: readonly Pick<Scene, "lines" | "labels">[]): Scene {
  return {
    pose,
    lines: parts.flatMap(({ lines }) => lines),
    labels: parts.flatMap(({ labels }) => labels),
  };
}
