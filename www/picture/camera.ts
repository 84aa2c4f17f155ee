// Where the picture is seen from, and where a point of space stands on paper; pure.
import type { Look } from "../model/picture_state.ts";
import { cross, directionOf, dot, minus, plus, times, turnAbout, type Vector } from "./space.ts";

/** How far the eye is from the origin, in units of space. */
const eyeDistance = 7;
/** In pixels of the page, so that letters and lines are as large in every card. */
export interface Paper {
  width: number;
  height: number;
}
/** Until the place of the drawing is measured. */
export const usualPaper: Paper = { width: 300, height: 300 };
/** The longest axis, across, with what perspective adds: it stays on the paper from wherever it is seen. */
const longest = 1.56;
/** Beyond the tips, for an edge of paper. */
const edge = 6;
/** Straight from above, right and up would be unknown. */
const steepest = 89;

export interface Camera {
  paper: Paper;
  /** Where the origin stands on the paper. */
  centre: { across: number; down: number };
  /** Pixels of one unit at the origin. */
  scale: number;
  eye: Vector;
  right: Vector;
  up: Vector;
  /** From the origin to the eye. */
  back: Vector;
}

export interface OnPaper {
  across: number;
  down: number;
  /** How far from the eye, along its line of sight. */
  depth: number;
}

const radians = (degrees: number) => (degrees * Math.PI) / 180;

export function cameraOf({ azimuthDeg, elevationDeg }: Look, paper: Paper = usualPaper): Camera {
  const azimuth = radians(azimuthDeg);
  const elevation = radians(elevationDeg);
  const back: Vector = [
    Math.cos(elevation) * Math.cos(azimuth),
    Math.cos(elevation) * Math.sin(azimuth),
    Math.sin(elevation),
  ];
  const right: Vector = [-Math.sin(azimuth), Math.cos(azimuth), 0];
  const scale = Math.max(1, Math.min(paper.width, paper.height) / 2 - edge) / longest;
  // More stands above the ground than below it.
  const spare = paper.height / 2 - edge - scale * longest;
  const centre = {
    across: paper.width / 2,
    down: paper.height / 2 + Math.max(0, Math.min(spare, scale * 0.2)),
  };
  return {
    paper,
    centre,
    scale,
    eye: times(back, eyeDistance),
    right,
    up: cross(back, right),
    back,
  };
}

/** Central projection: what is nearer is larger. */
export function onPaper(point: Vector, camera: Camera): OnPaper {
  const depth = eyeDistance - dot(point, camera.back);
  const size = (camera.scale * eyeDistance) / depth;
  return {
    across: camera.centre.across + size * dot(point, camera.right),
    down: camera.centre.down - size * dot(point, camera.up),
    depth,
  };
}

/** The look after going round by these angles: to the right, and up. */
export function orbited({ azimuthDeg, elevationDeg }: Look, rightDeg: number, upDeg: number): Look {
  return {
    azimuthDeg: inTurn(azimuthDeg + rightDeg),
    elevationDeg: Math.max(-steepest, Math.min(steepest, elevationDeg + upDeg)),
  };
}

/** From −180 (not included) to 180. */
function inTurn(degrees: number): number {
  const rest = ((degrees % 360) + 360) % 360;
  return rest > 180 ? rest - 360 : rest;
}

/** The turn that carries what is in front to the right and down by these angles, as seen. */
export function turnAsSeen(camera: Camera, rightDeg: number, downDeg: number) {
  const axis = plus(times(camera.up, rightDeg), times(camera.right, downDeg));
  return turnAbout(directionOf(axis) ?? camera.up, radians(Math.hypot(rightDeg, downDeg)));
}

/** The turn of the paper itself, counter-clockwise as seen. */
export function rollAsSeen(camera: Camera, counterClockwiseDeg: number) {
  return turnAbout(camera.back, radians(counterClockwiseDeg));
}

/** Whether the eye sees the side of a plane that its normal points to. */
export function isFacing(normal: Vector, point: Vector, camera: Camera): boolean {
  return dot(normal, minus(camera.eye, point)) > 0;
}
