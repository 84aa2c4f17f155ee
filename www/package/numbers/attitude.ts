// What an attitude is and tells.

import type { Convention, Direction, Survivor } from "../../../pkg/quatlas.js";
import * as core from "../../../pkg/rotation/quatlas_rotation.js";
import { QuatlasError } from "../quatlas_error.ts";
import {
  checkNumber,
  checkNumbers,
  kindOf,
  type Numbers,
  type Quaternion4,
  type Rows3,
  type Vector3,
} from "./checks.ts";
import {
  type AngleUnit,
  codeOf,
  conventionOf,
  directionPlace,
  type Sequence,
  sequencePlaces,
  unitPlace,
} from "./choices.ts";
import { called, put, registers, settle } from "./core.ts";

/** Three angles of a sequence, and whether it is locked. */
export interface EulerAngles {
  /** In the order of the sequence, in the unit that was asked for. */
  angles: Vector3;
  /** How far the middle angle is from gimbal lock, in that unit. */
  lockDistance: number;
  /**
   * Present in gimbal lock, where only the sum or the difference of the outer angles means anything; it is in
   * the unit of the angles.
   */
  gimbalLock?: { survivor: Survivor; angle: number };
}

/** A direction that the turn leaves as it is, and the angle about it. */
export interface AxisAngle {
  /** Of length 1; undefined where there is no turn. */
  axis: Vector3 | undefined;
  /** From 0 to half a turn. */
  angle: number;
}

/** Under this name every copy of quatlas finds what another computes with. */
export const CANONICAL: unique symbol = Symbol.for("quatlas.rotation");

/** A `Rotation` of this or of another copy of quatlas, such as that of another entry. */
export type RotationLike = Attitude;

/** What a rotation is and tells; see `Rotation`. */
export class Attitude {
  /** Of Hamilton's unit quaternion, body to world; not of that of another convention. */
  readonly w: number;
  readonly x: number;
  readonly y: number;
  readonly z: number;
  // What is computed with: not yet divided by its norm, so that every result is rounded once.
  readonly #w: number;
  readonly #x: number;
  readonly #y: number;
  readonly #z: number;

  /** @internal */
  protected constructor(maker: typeof CANONICAL) {
    if (maker !== CANONICAL) {
      const hint = "write Rotation.fromQuat(array, convention), or another of its makers";
      throw new QuatlasError("wrong-type", "a Rotation is not made by `new`", hint);
    }
    const from = registers();
    this.w = from[0] as number;
    this.x = from[1] as number;
    this.y = from[2] as number;
    this.z = from[3] as number;
    this.#w = from[4] as number;
    this.#x = from[5] as number;
    this.#y = from[6] as number;
    this.#z = from[7] as number;
    Object.freeze(this);
  }

  /** @internal Puts what is computed with into the registers. */
  static put(value: unknown, at: 0 | 4, what: string): void {
    const to = registers();
    if (typeof value === "object" && value !== null && #w in value) {
      to[at] = value.#w;
      to[at + 1] = value.#x;
      to[at + 2] = value.#y;
      to[at + 3] = value.#z;
      return;
    }
    const canonical = (value as { [CANONICAL]?: () => Numbers } | null | undefined)?.[
      CANONICAL
    ]?.();
    if (canonical === undefined) {
      const hint = "give a Rotation, such as Rotation.fromQuat(array, convention)";
      throw new QuatlasError("wrong-type", `${what} is ${kindOf(value)}`, hint);
    }
    put(checkNumbers(canonical, 4, what), at);
  }

  /** @internal */
  [CANONICAL](): Quaternion4 {
    return [this.#w, this.#x, this.#y, this.#z];
  }

  /**
   * The four numbers in a convention, in its order, with norm 1 and each within one roundoff.
   *
   * Of q and −q it is the one that the attitude was made with.
   *
   * @example
   * // A quarter turn about x: Hamilton, w first, and JPL, w last, have the same numbers, not conjugated.
   * const rolled = Rotation.fromAxisAngle([1, 0, 0], 90, "deg");
   * rolled.asQuat(HAMILTON); // [0.7071067811865476, 0.7071067811865476, 0, 0]
   * rolled.asQuat(JPL); // [0.7071067811865476, 0, 0, 0.7071067811865476]
   * rolled.asQuat(JPL_BODY_TO_WORLD)[0]; // -0.7071067811865476
   */
  asQuat(convention: Convention | string): Quaternion4 {
    const code = codeOf(conventionOf(convention));
    Attitude.put(this, 0, "this");
    settle(called(core.asQuaternion, code), "the attitude");
    return [...registers().subarray(0, 4)] as Quaternion4;
  }

  /**
   * The matrix that multiplies columns, row by row, each entry within one roundoff.
   *
   * `"body-to-world"` is `R_WB`, whose columns are the body's axes in the world; `"world-to-body"` is its
   * transpose.
   *
   * @example
   * const yawed = Rotation.fromAxisAngle([0, 0, 1], 90, "deg");
   * yawed.asMatrix("body-to-world")[0]; // [0, -1, 0]
   * yawed.asMatrix("world-to-body")[0]; // [0, 1, 0]
   */
  asMatrix(direction: Direction): Rows3 {
    const place = directionPlace(direction);
    Attitude.put(this, 0, "this");
    settle(called(core.asMatrix, place), "the attitude");
    const from = registers();
    return [
      [from[0], from[1], from[2]],
      [from[3], from[4], from[5]],
      [from[6], from[7], from[8]],
    ] as Rows3;
  }

  /**
   * Three Euler angles: `"ZYX"` about axes that move along, `"xyz"` about axes that stay.
   *
   * The outer ones are above −π and up to π, the middle one from −π/2 to π/2, or from 0 to π where the outer
   * axes are the same. In gimbal lock they still give the attitude, and `gimbalLock` says what is left of them.
   *
   * @example
   * const body = Rotation.fromEuler("ZYX", [30, 20, 10], "deg");
   * body.asEuler("xyz", "deg").angles.map(Math.round); // [10, 20, 30]: the same turns about fixed axes
   * body.asEuler("XYZ", "deg").angles.map(Math.round); // [-1, 22, 28]: other axes, other angles
   */
  asEuler(sequence: Sequence, unit: AngleUnit): EulerAngles {
    const [axes, frame] = sequencePlaces(sequence);
    const inUnit = unitPlace(unit);
    Attitude.put(this, 0, "this");
    settle(called(core.asEuler, axes, frame, inUnit), "the attitude");
    const [first, second, third, lockDistance, locked, angle] = registers() as unknown as number[];
    const euler = {
      angles: [first, second, third] as Vector3,
      lockDistance: lockDistance as number,
    };
    if (locked === 0) return euler;
    const survivor = locked === 1 ? "sum" : "difference";
    return { ...euler, gimbalLock: { survivor, angle: angle as number } };
  }

  /**
   * The axis, the same on both frames, and the angle of the shorter turn, right-handed.
   *
   * @example
   * const { axis, angle } = Rotation.fromAxisAngle([0, 0, 2], 270, "deg").asAxisAngle("deg");
   * axis; // [0, 0, -1]: a quarter turn the other way
   * Math.round(angle); // 90
   */
  asAxisAngle(unit: AngleUnit): AxisAngle {
    const inUnit = unitPlace(unit);
    Attitude.put(this, 0, "this");
    settle(called(core.asAxisAngle, inUnit), "the attitude");
    const [x, y, z, angle] = registers() as unknown as Quaternion4;
    const hasAxis = x !== 0 || y !== 0 || z !== 0;
    return { axis: hasAxis ? [x, y, z] : undefined, angle };
  }

  /**
   * The rotation vector: along the axis, as long as the angle of the shorter turn.
   *
   * @example
   * // Three quarters of a turn about z are a quarter turn about −z.
   * Rotation.fromRotvec([0, 0, 270], "deg").asRotvec("deg")[2].toFixed(9); // "-90.000000000"
   */
  asRotvec(unit: AngleUnit = "rad"): Vector3 {
    const inUnit = unitPlace(unit);
    Attitude.put(this, 0, "this");
    return this.#vector(called(core.asRotationVector, inUnit));
  }

  /**
   * The modified Rodrigues parameters, `u tan(θ/4)` of the shorter turn, as in SciPy.
   *
   * @example
   * Rotation.fromAxisAngle([1, 0, 0], 90, "deg").asMrp()[0].toFixed(6); // "0.414214": tan(22.5°)
   */
  asMrp(): Vector3 {
    Attitude.put(this, 0, "this");
    return this.#vector(called(core.asModifiedRodrigues));
  }

  /**
   * The Gibbs vector (Rodrigues parameters), `u tan(θ/2)`. Half a turn has none: a `QuatlasError`, `too-large`.
   *
   * @example
   * Rotation.fromAxisAngle([1, 0, 0], 90, "deg").asGibbs()[0].toFixed(6); // "1.000000": tan(45°)
   */
  asGibbs(): Vector3 {
    Attitude.put(this, 0, "this");
    return this.#vector(called(core.asGibbs));
  }

  /**
   * Coordinates on the body's axes, on those of the world: `R_WB v`. SciPy's `apply(v)`.
   *
   * @example
   * Rotation.fromAxisAngle([0, 0, 1], 90, "deg").apply([1, 0, 0]); // [0, 1, 0]
   */
  apply(vector: Numbers): Vector3 {
    return this.#applied(vector, 0);
  }

  /**
   * Coordinates on the world's axes, on those of the body: `R_BW v`. SciPy's `apply(v, inverse=True)`.
   *
   * @example
   * Rotation.fromAxisAngle([0, 0, 1], 90, "deg").applyInverse([1, 0, 0]); // [0, -1, 0]
   */
  applyInverse(vector: Numbers): Vector3 {
    return this.#applied(vector, 1);
  }

  /**
   * The angle of the turn, from 0 to π, or to 180.
   *
   * @example
   * Rotation.fromRotvec([0, -2, 0]).magnitude(); // 2
   */
  magnitude(unit: AngleUnit = "rad"): number {
    const inUnit = unitPlace(unit);
    Attitude.put(this, 0, "this");
    return called(core.magnitude, inUnit);
  }

  /**
   * The angle of the turn that leads from one attitude to the other, from 0 to π: the geodesic distance. It
   * keeps its digits however small it is, and is 0 between q and −q.
   *
   * @example
   * const yawed = Rotation.fromAxisAngle([0, 0, 1], 90, "deg");
   * const rolled = Rotation.fromAxisAngle([1, 0, 0], 90, "deg");
   * yawed.angleTo(rolled, "deg").toFixed(9); // "120.000000000"
   */
  angleTo(other: RotationLike, unit: AngleUnit = "rad"): number {
    const inUnit = unitPlace(unit);
    this.#putBoth(other);
    return called(core.angleTo, inUnit);
  }

  /**
   * The Frobenius norm of the difference of the two matrices, `2√2 sin(θ/2)`, from 0 to 2√2.
   *
   * @example
   * const yawed = Rotation.fromAxisAngle([0, 0, 1], 90, "deg");
   * yawed.chordalDistance(Rotation.identity()).toFixed(9); // "2.000000000"
   */
  chordalDistance(other: RotationLike): number {
    this.#putBoth(other);
    return called(core.chordalDistance);
  }

  /**
   * The smaller of the norms of p − q and p + q of the unit quaternions, `2 sin(θ/4)`, from 0 to √2.
   *
   * @example
   * const yawed = Rotation.fromAxisAngle([0, 0, 1], 120, "deg");
   * yawed.quaternionDistance(Rotation.identity()).toFixed(9); // "1.000000000"
   */
  quaternionDistance(other: RotationLike): number {
    this.#putBoth(other);
    return called(core.quaternionDistance);
  }

  /**
   * Whether both are the same attitude but for an angle, in radians; q and −q are.
   *
   * @example
   * const yawed = Rotation.fromQuat([0, 0, 0.6, 0.8], JPL);
   * yawed.approxEqual(Rotation.fromQuat([0, 0, -0.6, -0.8], JPL), 1e-15); // true
   * yawed.approxEqual(yawed.inv(), 0.1); // false
   */
  approxEqual(other: RotationLike, toleranceRad: number): boolean {
    return this.angleTo(other) <= checkNumber(toleranceRad, "the tolerance");
  }

  /**
   * Hamilton's four numbers by name, which quatlas reads back as this attitude.
   *
   * @example
   * String(Rotation.fromQuat([0, 0, 0.6, 0.8], JPL)); // "w=0.8 x=0 y=0 z=0.6"
   */
  toString(): string {
    return `w=${this.w} x=${this.x} y=${this.y} z=${this.z}`;
  }

  #applied(vector: Numbers, direction: number): Vector3 {
    const numbers = checkNumbers(vector, 3, "the vector");
    Attitude.put(this, 0, "this");
    put(numbers, 4);
    return this.#vector(called(core.apply, direction));
  }

  #putBoth(other: RotationLike): void {
    Attitude.put(this, 0, "this");
    Attitude.put(other, 4, "the other");
  }

  #vector(outcome: number): Vector3 {
    settle(outcome, "the answer");
    const from = registers();
    return [from[0] as number, from[1] as number, from[2] as number];
  }
}
