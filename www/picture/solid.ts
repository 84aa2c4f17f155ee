// The body: a block with a nose along x, a letter on the side of each of its axes; pure.
import { cross, directionOf, dot, minus, type Vector } from "./space.ts";

export interface Face {
  /** Corners in the body frame, counter-clockwise as seen from outside. */
  corners: readonly Vector[];
  /** Points outwards, of length 1. */
  normal: Vector;
  /** The axis whose letter stands on it. */
  letter?: "x" | "y" | "z";
  /** The strokes of the letter, in the body frame. */
  strokes: readonly (readonly [Vector, Vector])[];
}

const [back, shoulder, tip] = [-0.56, 0.3, 0.6];
const [halfWidth, halfHeight] = [0.36, 0.22];
const [tipWidth, tipHeight] = [0.14, 0.09];

const at = (x: number, y: number, z: number): Vector => [x, y, z];
/** Four corners about the x axis, from y, z both positive. */
const ring = (x: number, y: number, z: number) => [
  at(x, y, z),
  at(x, -y, z),
  at(x, -y, -z),
  at(x, y, -z),
];

const rear = ring(back, halfWidth, halfHeight);
const middle = ring(shoulder, halfWidth, halfHeight);
const front = ring(tip, tipWidth, tipHeight);

/** The sides between two rings: top, right, bottom, left. */
function sidesOf(behind: readonly Vector[], ahead: readonly Vector[]): Vector[][] {
  return behind.map((corner, index) => {
    const next = (index + 1) % behind.length;
    return [corner, behind[next], ahead[next], ahead[index]] as Vector[];
  });
}

const letterStrokes = {
  x: [
    [0, 0, 1, 1],
    [0, 1, 1, 0],
  ],
  y: [
    [0.5, 0.45, 0, 1],
    [1, 1, 0.3, 0],
  ],
  z: [
    [0, 1, 1, 1],
    [1, 1, 0, 0],
    [0, 0, 1, 0],
  ],
} as const;

/** A letter written on a face: from its middle, to the right and up as one reads it. */
function written(
  letter: "x" | "y" | "z",
  [middle, right, up]: readonly [Vector, Vector, Vector],
  height: number,
): [Vector, Vector][] {
  const point = (across: number, above: number): Vector => {
    const [a, b] = [(across - 0.5) * 0.72 * height, (above - 0.5) * height];
    return [0, 1, 2].map(
      (axis) => (middle[axis] ?? 0) + a * (right[axis] ?? 0) + b * (up[axis] ?? 0),
    ) as unknown as Vector;
  };
  return letterStrokes[letter].map(([a, b, c, d]) => [point(a, b), point(c, d)]);
}

function face(
  corners: readonly Vector[],
  letter?: "x" | "y" | "z",
  strokes: readonly (readonly [Vector, Vector])[] = [],
): Face {
  const [a, b, c] = corners as [Vector, Vector, Vector];
  const normal = directionOf(cross(minus(b, a), minus(c, b))) ?? a;
  // Counter-clockwise from outside, whichever way they were listed.
  return dot(normal, a) > 0
    ? { corners, normal, strokes, ...(letter ? { letter } : {}) }
    : face([...corners].reverse(), letter, strokes);
}

/** Letters stand beside the axis, which comes out of the middle of a side. */
const [mx, length] = [-0.32, 0.24];
const [top, right, bottom, left] = sidesOf(rear, middle) as [
  Vector[],
  Vector[],
  Vector[],
  Vector[],
];

export const faces: readonly Face[] = [
  face(rear),
  face(top, "z", written("z", [at(mx, 0, halfHeight), at(0, -1, 0), at(1, 0, 0)], length)),
  face(right),
  face(bottom),
  face(left, "y", written("y", [at(mx, halfWidth, 0), at(-1, 0, 0), at(0, 0, 1)], length)),
  ...sidesOf(middle, front).map((corners) => face(corners)),
  face(front, "x", written("x", [at(tip, 0, 0), at(0, 1, 0), at(0, 0, 1)], 0.12)),
];
