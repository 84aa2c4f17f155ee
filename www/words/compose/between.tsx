// The words of what is between p and q.
import type { Side, Verdict } from "../../engine.ts";
import type { Unit } from "../../model/page_state.ts";

export const title = "Between p and q";
export const unread = "Both texts have to be read first.";

/** What p and q are to each other; without an angle they are exactly one rotation. */
export function verdict(verdict: Verdict, apart: string | undefined, areMatrices: boolean): string {
  const rest = apart === undefined ? "" : `, but for ${apart}`;
  switch (verdict) {
    case "equal":
      return `p and q are one rotation${rest}.`;
    case "opposite":
      return `p and q are one rotation by opposite quaternions: q is −p${rest}.`;
    case "conjugated":
      return `q is the ${areMatrices ? "transpose" : "conjugate"} of p: the inverse rotation, ${apart} apart.`;
    case "scalar-moved":
      return `The same four numbers with w at the other end: as they are read, p and q are ${apart} apart.`;
    case "scalar-moved-and-conjugated":
      return `The same four numbers, conjugated and with w at the other end: as they are read, p and q are ${apart} apart.`;
    case "different":
      return `p and q are two rotations, ${apart} apart.`;
  }
}

export const turn = "From p to q";
export const turnOn = { local: "on the body's axes", global: "on the world's axes" };
export const turnAbout = (angle: string, axis: string) => `rad · ${angle} about ${axis}`;
/** By the axes of a small rotation. */
export const error = {
  local: "The error quaternion, on the body's axes",
  global: "The error quaternion, on the world's axes",
};
export const errorIn = (convention: string) => `δq, ${convention}`;
export const errorOf = (sign: string, side: Side) =>
  side === "right" ? `q = p ${sign} δq` : `q = δq ${sign} p`;

export const distances = "How far";
export const geodesic = "angle (geodesic)";
export const chordal = "chordal";
export const nearer = (symbol: string) => `${symbol} is the nearer of q and −q`;
export const euler = (sequence: string) => `Euler angles ${sequence}`;
export const eulerDifference = "of q less those of p";
export const noTurn = (unit: Unit) => `${unit}, by the shorter way round; no rotation`;

export const rate = "The rate from p to q";
export const within = "in";
export const duration = "time from p to q";
export const rateLead = "A time, as 0.25 s or 250 ms, tells the angular velocity.";
export const rateOn = { local: "ω on the body's axes", global: "ω on the world's axes" };
export const rateAbout = (perSecond: string, axis: string) =>
  `rad/s · ${perSecond}/s about ${axis}`;
/** A quaternion holds half of the angle. */
export const halfForgotten = (off: string) =>
  `The usual mistake is half of it, from the half angle of the quaternion: after this time it is ${off} short of q.`;

export const way = "The way from p to q";
export const part = "part t of the way";
export const at = (part: string) => `at t = ${part}`;
export const halfway = (isHalfTurn: boolean) =>
  isHalfTurn ? "half way, one of two" : "half way, the mean";
export const halfTurn =
  "Half a turn apart: the way round the other side is as short, so the axis, the rate and what is on the way are a choice of two.";
export const picture = "Picture of the way from p to q";
export const pictureSays = (part: string) =>
  `The body B at t = ${part}, between the outlines of p and q.`;

/** What copied numbers say they are; plain ASCII, since they go into source files. */
export const copies = {
  differences: (sequence: string, unit: Unit) =>
    `angles ${sequence} of q less those of p in ${unit}, by the shorter way round; no rotation`,
  rate: {
    local: "angular velocity in rad/s on the body axes",
    global: "angular velocity in rad/s on the world axes",
  },
};
