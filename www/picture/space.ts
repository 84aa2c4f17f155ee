// Vectors and turns for drawing; pure. What a quaternion means is decided in the core, not here.

export type Vector = readonly [number, number, number];
/** Hamilton components of a unit quaternion, by name; it turns by q v q*. */
export interface Quaternion {
  w: number;
  x: number;
  y: number;
  z: number;
}

export const origin: Vector = [0, 0, 0];
/** x, y, z. */
export const unitVectors: readonly [Vector, Vector, Vector] = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

export const plus = (a: Vector, b: Vector): Vector => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const minus = (a: Vector, b: Vector): Vector => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const times = (a: Vector, by: number): Vector => [a[0] * by, a[1] * by, a[2] * by];
export const dot = (a: Vector, b: Vector) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a: Vector, b: Vector): Vector => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
/** The point that lies this part of the way from one to the other. */
export const between = (a: Vector, b: Vector, part: number): Vector =>
  plus(a, times(minus(b, a), part));

/** The vector with length 1; nothing for one that has no direction. */
export function directionOf(vector: Vector): Vector | undefined {
  // Scaled first, so that no square is too large or too small.
  const largest = Math.max(...vector.map(Math.abs));
  if (!(largest > 0 && Number.isFinite(largest))) return undefined;
  const scaled = times(vector, 1 / largest);
  return times(scaled, 1 / Math.hypot(...scaled));
}

/** The right-handed turn about an axis of length 1. */
export function turnAbout(axis: Vector, angleRad: number): Quaternion {
  const [x, y, z] = times(axis, Math.sin(angleRad / 2));
  return { w: Math.cos(angleRad / 2), x, y, z };
}

/** First `right`, then `left`, both about fixed axes. */
export function composed(left: Quaternion, right: Quaternion): Quaternion {
  const a: Vector = [left.x, left.y, left.z];
  const b: Vector = [right.x, right.y, right.z];
  const [x, y, z] = plus(plus(times(b, left.w), times(a, right.w)), cross(a, b));
  return { w: left.w * right.w - dot(a, b), x, y, z };
}

export function ofNormOne(quaternion: Quaternion): Quaternion {
  const { w, x, y, z } = quaternion;
  const norm = Math.hypot(w, x, y, z);
  return { w: w / norm, x: x / norm, y: y / norm, z: z / norm };
}

/** The vector after the turn. */
export function turned(vector: Vector, { w, x, y, z }: Quaternion): Vector {
  const axis: Vector = [x, y, z];
  const twice = times(cross(axis, vector), 2);
  return plus(plus(vector, times(twice, w)), cross(axis, twice));
}

/** Some direction at a right angle to this one. */
export function acrossOf(direction: Vector): Vector {
  const sizes = direction.map(Math.abs);
  const least = unitVectors[sizes.indexOf(Math.min(...sizes))] ?? unitVectors[0];
  return directionOf(cross(direction, least)) ?? unitVectors[0];
}
