// An attitude as a value of JavaScript: how it is made, and what others it makes.

import type { Convention, Direction, Perturbation, RateAxes } from "../../../pkg/quatlas.js";
import * as core from "../../../pkg/rotation/quatlas_rotation.js";
import { QuatlasError } from "../quatlas_error.ts";
import { Attitude, CANONICAL, type RotationLike } from "./attitude.ts";
import {
  checkNumber,
  checkNumbers,
  checkRows,
  kindOf,
  type Numbers,
  type Vector3,
} from "./checks.ts";
import {
  type AngleUnit,
  codeOf,
  conventionOf,
  directionPlace,
  perturbationPlace,
  ratePlace,
  type Sequence,
  sequencePlaces,
  unitPlace,
} from "./choices.ts";
import { called, put, registers, settle } from "./core.ts";
import type { TaggedQuaternion } from "./tagged_quaternion.ts";

/** The rotation nearest to nine numbers, and how far it is. */
export interface NearestRotation {
  rotation: Rotation;
  /** The Frobenius norm of the difference of the two matrices. */
  correction: number;
}

/**
 * The attitude of a body in the world, free of any convention: a small frozen value, with nothing to free.
 *
 * `R_WB` takes coordinates on the body's axes to coordinates on the world's, and is the turn that carries the
 * world's axes onto the body's. The members `w`, `x`, `y`, `z` are Hamilton's unit quaternion of it. Numbers of
 * any convention come in by `fromQuat` and go out by `asQuat`; both ask for the convention. Every result has
 * the bits of the Rust crate. What cannot be computed with is a `QuatlasError`.
 *
 * @example
 * // Four numbers from a JPL filter: x y z w, world to body. The body is yawed by 90°.
 * const body = Rotation.fromQuat([0, 0, Math.SQRT1_2, Math.SQRT1_2], JPL);
 * body.apply([1, 0, 0]); // [0, 1, 0]: the body's x axis, seen from the world
 * body.applyInverse([1, 0, 0]); // [0, -1, 0]: the world's x axis, seen from the body
 */
export class Rotation extends Attitude {
  static {
    // A console calls it so, also where a bundler has given it another name.
    Object.defineProperty(Rotation, "name", { value: "Rotation" });
  }

  /**
   * The attitude in which the body's axes are the world's.
   *
   * @example
   * Rotation.identity().asQuat(JPL); // [0, 0, 0, 1]
   */
  static identity(): Rotation {
    put([1, 0, 0, 0]);
    return Rotation.#made(called(core.fromQuaternion, 0), "the identity");
  }

  /**
   * The attitude of four numbers of any norm but zero, in the order and meaning of their convention, or of a
   * `TaggedQuaternion`, which has its own.
   *
   * In the entry `quatlas` the convention may also be the id of a library: what it stores, in its order.
   *
   * @example
   * const numbers = [0, 0, Math.SQRT1_2, Math.SQRT1_2];
   * Rotation.fromQuat(numbers, JPL).apply([1, 0, 0]); // [0, 1, 0]
   * // The same numbers with w first are half a turn about another axis.
   * Rotation.fromQuat(numbers, HAMILTON).apply([1, 0, 0]); // [-1, 0, 0]
   */
  static fromQuat(array: Numbers, convention: Convention | string): Rotation;
  static fromQuat(quaternion: TaggedQuaternion): Rotation;
  static fromQuat(value: Numbers | TaggedQuaternion, convention?: Convention | string): Rotation {
    const isTagged = convention === undefined && isObject(value) && "convention" in value;
    const { array, convention: tag } = isTagged ? value : { array: value as Numbers, convention };
    const code = codeOf(conventionOf(tag));
    const numbers = checkNumbers(array, 4, "the quaternion");
    put(numbers);
    return Rotation.#made(called(core.fromQuaternion, code), "the quaternion");
  }

  /**
   * The same attitude as a value of this copy of quatlas: of another copy's, such as that of another entry, or of
   * one that is its own already.
   *
   * @example
   * // What another copy made is told by its shape, never by its class.
   * Rotation.from(Rotation.fromGibbs([0, 0, 1])).apply([1, 0, 0]); // [0, 1, 0]
   */
  static from(rotation: RotationLike): Rotation {
    if (rotation instanceof Rotation) return rotation;
    Attitude.put(rotation, 0, "the rotation");
    return Rotation.#made(called(core.fromCanonical), "the rotation");
  }

  /**
   * The attitude of a rotation matrix that multiplies columns, given by its rows.
   *
   * It may be rounded to single precision; what is farther than 1e-6 from a rotation is refused
   * (`not-a-rotation`, `reflection`): see `nearestToMatrix`. Nine numbers in one list are refused too, as three.js
   * and gl-matrix store columns, and NumPy rows.
   *
   * @example
   * const rows = [[0, -1, 0], [1, 0, 0], [0, 0, 1]];
   * Rotation.fromMatrix(rows, "body-to-world").apply([1, 0, 0]); // [0, 1, 0]
   * Rotation.fromMatrix(rows, "world-to-body").apply([1, 0, 0]); // [0, -1, 0]
   */
  static fromMatrix(rows: readonly Numbers[], direction: Direction): Rotation {
    const { rotation, isRotation } = Rotation.#nearest(rows, direction);
    if (isRotation) return rotation;
    const hint =
      "give orthogonal unit rows, or ask Rotation.nearestToMatrix for the nearest rotation";
    throw new QuatlasError(
      "not-a-rotation",
      "the matrix is farther than 1e-6 from a rotation",
      hint,
    );
  }

  /**
   * The rotation nearest to a matrix, by the Frobenius norm, whatever its scale, and how far it is.
   *
   * @example
   * // Three decimals of a turn by 30° about z.
   * const rows = [[0.866, -0.5, 0], [0.5, 0.866, 0], [0, 0, 1]];
   * const { rotation, correction } = Rotation.nearestToMatrix(rows, "body-to-world");
   * rotation.asRotvec("deg")[2].toFixed(2); // "30.00"
   * correction < 1e-4; // true
   */
  static nearestToMatrix(rows: readonly Numbers[], direction: Direction): NearestRotation {
    const { rotation, correction } = Rotation.#nearest(rows, direction);
    return { rotation, correction };
  }

  /**
   * The attitude of three Euler angles in the order of their sequence: `"ZYX"` about axes that move along
   * (intrinsic), `"xyz"` about axes that stay (extrinsic), as in SciPy.
   *
   * Whole quarter turns in degrees are exact.
   *
   * @example
   * // Yaw, then pitch about the axis that the yaw has moved.
   * Rotation.fromEuler("ZYX", [90, 90, 0], "deg").apply([1, 0, 0]); // [0, 0, -1]
   * // About fixed axes the same angles end elsewhere.
   * Rotation.fromEuler("zyx", [90, 90, 0], "deg").apply([1, 0, 0]); // [0, 1, 0]
   */
  static fromEuler(sequence: Sequence, angles: Numbers, unit: AngleUnit): Rotation {
    const [axes, frame] = sequencePlaces(sequence);
    const inUnit = unitPlace(unit);
    put(checkNumbers(angles, 3, "the list of angles"));
    return Rotation.#made(called(core.fromEuler, axes, frame, inUnit), "the list of angles");
  }

  /**
   * The attitude after a right-handed turn about an axis of any length.
   *
   * @example
   * Rotation.fromAxisAngle([0, 0, 5], 90, "deg").apply([1, 0, 0]); // [0, 1, 0]
   */
  static fromAxisAngle(axis: Numbers, angle: number, unit: AngleUnit): Rotation {
    const inUnit = unitPlace(unit);
    const size = checkNumber(angle, "the angle");
    putDirection(axis, 0, "the axis");
    return Rotation.#made(called(core.fromAxisAngle, size, inUnit), "the turn");
  }

  /**
   * The attitude after the turn of a rotation vector, `Exp(v)`: about v, by its length.
   *
   * @example
   * Rotation.fromRotvec([0, 0, Math.PI / 2]).asQuat(JPL)[2]; // 0.7071067811865475
   */
  static fromRotvec(vector: Numbers, unit: AngleUnit = "rad"): Rotation {
    const inUnit = unitPlace(unit);
    put(checkNumbers(vector, 3, "the rotation vector"));
    return Rotation.#made(called(core.fromRotationVector, inUnit), "the rotation vector");
  }

  /**
   * The attitude of modified Rodrigues parameters, `u tan(θ/4)`.
   *
   * @example
   * Rotation.fromMrp([0, 0, Math.tan(Math.PI / 8)]).magnitude("deg").toFixed(9); // "90.000000000"
   */
  static fromMrp(vector: Numbers): Rotation {
    put(checkNumbers(vector, 3, "the vector"));
    return Rotation.#made(called(core.fromModifiedRodrigues), "the vector");
  }

  /**
   * The attitude of a Gibbs vector (Rodrigues parameters), `u tan(θ/2)`.
   *
   * @example
   * Rotation.fromGibbs([0, 0, 1]).apply([1, 0, 0]); // [0, 1, 0]
   */
  static fromGibbs(vector: Numbers): Rotation {
    put(checkNumbers(vector, 3, "the vector"));
    return Rotation.#made(called(core.fromGibbs), "the vector");
  }

  /**
   * The shortest turn that brings a vector of the body along one of the world, both of any length: three's
   * `setFromUnitVectors(body, world)`.
   *
   * Between opposite vectors all ways are as short; the axis is then at right angles to the body's vector, and to the
   * axis of its smallest coordinate.
   *
   * @example
   * const turn = Rotation.fromTwoVectors([1, 0, 0], [0, 0, 2]);
   * turn.apply([1, 0, 0])[2].toFixed(9); // "1.000000000"
   * turn.apply([0, 1, 0])[1].toFixed(9); // "1.000000000": the axis is −y
   */
  static fromTwoVectors(body: Numbers, world: Numbers): Rotation {
    putDirection(body, 0, "the vector of the body");
    putDirection(world, 3, "the vector of the world");
    return Rotation.#made(called(core.fromTwoVectors), "the turn");
  }

  /**
   * An attitude at random, uniform over all, and the same for the same seed on every machine.
   *
   * The seed is a whole number from 0 to 2^53 − 1.
   *
   * @example
   * Rotation.random(1).angleTo(Rotation.random(2)) > 0.1; // true
   * Rotation.random(1).angleTo(Rotation.random(1)); // 0
   */
  static random(seed: number): Rotation {
    if (!Number.isSafeInteger(seed) || seed < 0) {
      const hint = "give a whole number from 0 on; the same one gives the same attitude";
      throw new QuatlasError("wrong-type", `the seed is ${kindOf(seed)}`, hint);
    }
    // The registers are made with the first call.
    registers();
    return Rotation.#made(called(core.random, seed), "the attitude");
  }

  /**
   * This attitude, with another turn on its own axes: `R_WB.andThen(R_BC)` is `R_WC`.
   *
   * It reads from the outer frame to the inner one, whatever order the factors of a convention stand in.
   *
   * @example
   * // A body yawed by 90°; on it a camera that is pitched by 90° about the body's y.
   * const body = Rotation.fromAxisAngle([0, 0, 1], 90, "deg");
   * const camera = Rotation.fromAxisAngle([0, 1, 0], 90, "deg");
   * body.andThen(camera).apply([0, 0, 1]); // [0, 1, 0]: the camera looks along the world's y
   * camera.andThen(body).apply([0, 0, 1]); // [1, 0, 0]
   */
  andThen(next: RotationLike): Rotation {
    Attitude.put(this, 0, "this");
    Attitude.put(next, 4, "the next");
    return Rotation.#made(called(core.product), "the product");
  }

  /**
   * The attitude of the world in the body: `R_BW`.
   *
   * @example
   * const yawed = Rotation.fromAxisAngle([0, 0, 1], 90, "deg");
   * yawed.inv().apply([1, 0, 0]); // [0, -1, 0]
   */
  inv(): Rotation {
    Attitude.put(this, 0, "this");
    return Rotation.#made(called(core.inverse), "the inverse");
  }

  /**
   * The turn about the same axis by a multiple of the angle of the shorter way: SciPy's `r ** n`.
   *
   * @example
   * const yawed = Rotation.fromAxisAngle([0, 0, 1], 90, "deg");
   * yawed.pow(-1 / 3).asRotvec("deg")[2].toFixed(9); // "-30.000000000"
   */
  pow(exponent: number): Rotation {
    const times = checkNumber(exponent, "the exponent");
    Attitude.put(this, 0, "this");
    return Rotation.#made(called(core.power, times), "the power");
  }

  /**
   * The attitude a part of the way to another, about one axis at a constant rate, along the shorter way: 0 is
   * this one, 1 the other; beyond, the turn goes on.
   *
   * @example
   * const yawed = Rotation.fromAxisAngle([0, 0, 1], 90, "deg");
   * Rotation.identity().slerp(yawed, 1 / 3).asRotvec("deg")[2].toFixed(9); // "30.000000000"
   * Rotation.identity().slerp(yawed, 2).apply([1, 0, 0])[0].toFixed(9); // "-1.000000000"
   */
  slerp(other: RotationLike, fraction: number): Rotation {
    const part = checkNumber(fraction, "the fraction");
    Attitude.put(this, 0, "this");
    Attitude.put(other, 4, "the other");
    return Rotation.#made(called(core.slerp, part), "the attitude between");
  }

  /**
   * This attitude turned by a small or large rotation vector, in radians: ⊞, `R_WB Exp(v)` on the axes of the
   * body (`"local"`), `Exp(v) R_WB` on those of the world (`"global"`). A quaternion of a convention has a side and
   * a sign of its own: see `TaggedQuaternion.plus`.
   *
   * @example
   * const yawed = Rotation.fromAxisAngle([0, 0, 1], 90, "deg");
   * yawed.plus([Math.PI / 2, 0, 0], "local").apply([0, 0, 1])[0].toFixed(9); // "1.000000000"
   * yawed.plus([Math.PI / 2, 0, 0], "global").apply([0, 0, 1])[1].toFixed(9); // "-1.000000000"
   */
  plus(vectorRad: Numbers, axes: Perturbation): Rotation {
    const place = perturbationPlace(axes);
    const vector = checkNumbers(vectorRad, 3, "the rotation vector");
    Attitude.put(this, 0, "this");
    put(vector, 4);
    return Rotation.#made(called(core.turnedBy, place), "the attitude");
  }

  /**
   * The rotation vector, in radians, that leads from another attitude to this one, on the axes of that one
   * (`"local"`) or of the world (`"global"`): ⊟, so that `from.plus(this.minus(from, axes), axes)` is this one.
   *
   * @example
   * const yawed = Rotation.fromAxisAngle([0, 0, 1], 90, "deg");
   * const rolled = yawed.andThen(Rotation.fromRotvec([0.25, 0, 0]));
   * rolled.minus(yawed, "local")[0].toFixed(9); // "0.250000000": about the body's x
   * rolled.minus(yawed, "global")[1].toFixed(9); // "0.250000000": which is the world's y
   */
  minus(from: RotationLike, axes: Perturbation): Vector3 {
    return Rotation.#rate(from, this, 1, perturbationPlace(axes));
  }

  /**
   * The attitude after so many seconds at an angular velocity, in rad/s, on the axes of the body, as a gyroscope
   * measures it, or of the world.
   *
   * The rate is constant, for which it is exact, or a function of the seconds from now on, for which it is of
   * fourth order in them (Magnus).
   *
   * @example
   * const yawed = Rotation.fromAxisAngle([0, 0, 1], 90, "deg");
   * const rate = [Math.PI / 2, 0, 0];
   * yawed.integrate(rate, 1, "body").apply([0, 0, 1])[0].toFixed(9); // "1.000000000"
   * yawed.integrate(rate, 1, "world").apply([0, 0, 1])[1].toFixed(9); // "-1.000000000"
   */
  integrate(
    rateRad: Numbers | ((seconds: number) => Numbers),
    seconds: number,
    axes: RateAxes,
  ): Rotation {
    const place = ratePlace(axes);
    const step = checkNumber(seconds, "the time");
    const at = (part: number) => (typeof rateRad === "function" ? rateRad(part * step) : rateRad);
    const isConstant = typeof rateRad !== "function";
    const early = [...checkNumbers(at(0.5 - Math.sqrt(3) / 6), 3, "the rate")];
    const late = isConstant ? early : [...checkNumbers(at(0.5 + Math.sqrt(3) / 6), 3, "the rate")];
    Attitude.put(this, 0, "this");
    put(early, 4);
    put(late, 7);
    const outcome = called(core.integrate, place, Number(!isConstant), step);
    return Rotation.#made(outcome, "the attitude");
  }

  /**
   * The constant angular velocity, in rad/s, that leads to a later attitude in so many seconds.
   *
   * @example
   * const yawed = Rotation.fromAxisAngle([0, 0, 1], 90, "deg");
   * const later = yawed.andThen(Rotation.fromRotvec([0.25, 0, 0]));
   * yawed.rateTo(later, 0.5, "body")[0].toFixed(9); // "0.500000000"
   * yawed.rateTo(later, 0.5, "world")[1].toFixed(9); // "0.500000000"
   */
  rateTo(later: RotationLike, seconds: number, axes: RateAxes): Vector3 {
    const step = checkNumber(seconds, "the time");
    if (step === 0) {
      throw new QuatlasError(
        "too-large",
        "the time is 0 s",
        "give the time between the two attitudes",
      );
    }
    return Rotation.#rate(this, later, step, ratePlace(axes));
  }

  static #rate(from: RotationLike, to: RotationLike, seconds: number, axes: number): Vector3 {
    Attitude.put(from, 0, "the first");
    Attitude.put(to, 4, "the second");
    settle(called(core.rateTo, axes, seconds), "the rate");
    return [...registers().subarray(0, 3)] as Vector3;
  }

  static #nearest(rows: readonly Numbers[], direction: Direction) {
    const place = directionPlace(direction);
    put(checkRows(rows));
    const rotation = Rotation.#made(called(core.fromMatrix, place), "the matrix");
    const [correction, isRotation] = registers().subarray(8, 10);
    return { rotation, correction: correction as number, isRotation: isRotation === 1 };
  }

  static #made(outcome: number, what: string): Rotation {
    settle(outcome, what);
    return new Rotation(CANONICAL);
  }
}

/** Puts a vector that is not zero into the registers. */
function putDirection(vector: Numbers, at: number, what: string): void {
  const numbers = checkNumbers(vector, 3, what);
  if (numbers.every((number) => number === 0)) {
    throw new QuatlasError("zero-vector", `${what} has length 0`, "give one that has a direction");
  }
  put(numbers, at);
}

function isObject(value: unknown): value is object {
  return typeof value === "object" && value !== null;
}
