// Four numbers with the convention that says what they mean.

import type { Convention, IncrementSign, RateAxes, Side } from "../../../pkg/quatlas.js";
import * as core from "../../../pkg/rotation/quatlas_rotation.js";
import { QuatlasError } from "../quatlas_error.ts";
import { checkNumbers, kindOf, type Numbers, type Quaternion4, type Vector3 } from "./checks.ts";
import { codeOf, conventionOf, ratePlace, sidePlace, signPlace } from "./choices.ts";
import { called, put, registers, settle } from "./core.ts";

/** Four rows of four numbers. */
export type Rows4 = [Quaternion4, Quaternion4, Quaternion4, Quaternion4];

/**
 * Four numbers as they are written, with the convention that says what they mean: a frozen value.
 *
 * What comes in and goes out is numbers in that convention, of any norm: products are those of its algebra, ⊙ or
 * ⊗, small turns stand on its side and have its sign. Two with different conventions are not multiplied: a
 * `QuatlasError`, `mixed-conventions`.
 *
 * @example
 * // i times j is k for Hamilton, and −k for JPL.
 * const [i, j] = [[1, 0, 0, 0], [0, 1, 0, 0]].map((array) => TaggedQuaternion.of(array, JPL));
 * i.times(j).array; // [0, 0, -1, 0]
 */
export class TaggedQuaternion {
  static {
    // A console calls it so, also where a bundler has given it another name.
    Object.defineProperty(TaggedQuaternion, "name", { value: "TaggedQuaternion" });
  }

  /** In the order of the convention. */
  readonly array: Readonly<Quaternion4>;
  readonly convention: Convention;
  readonly #code: number;

  private constructor(array: Quaternion4, convention: Convention, code: number) {
    this.array = Object.freeze(array);
    this.convention = convention;
    this.#code = code;
    Object.freeze(this);
  }

  /**
   * Four numbers, and what they mean.
   *
   * @example
   * TaggedQuaternion.of([0, 0, 0.6, 0.8], JPL).to(HAMILTON).array; // [0.8, 0, 0, 0.6]
   */
  static of(array: Numbers, convention: Convention | string): TaggedQuaternion {
    const { order, handedness, function: does, direction, perturbation } = conventionOf(convention);
    const kept = Object.freeze({ order, handedness, function: does, direction, perturbation });
    const code = codeOf(kept);
    const numbers = [...checkNumbers(array, 4, "the quaternion")] as Quaternion4;
    return new TaggedQuaternion(numbers, kept, code);
  }

  /**
   * The product in the algebra of the convention, this one on the left: ⊙ or ⊗.
   *
   * @example
   * const yawed = TaggedQuaternion.of([0, 0, 0.6, 0.8], JPL);
   * const rolled = TaggedQuaternion.of([0.6, 0, 0, 0.8], JPL);
   * yawed.times(rolled).array[1].toFixed(2); // "-0.36": in Hamilton's algebra it is 0.36
   */
  times(right: TaggedQuaternion): TaggedQuaternion {
    this.#putBoth(right);
    return this.#made(called(core.taggedProduct, this.#code), "the product");
  }

  /**
   * With the signs of the vector part changed.
   *
   * @example
   * TaggedQuaternion.of([0.8, 0, 0, 0.6], HAMILTON).conjugate().array; // [0.8, -0, -0, -0.6]
   */
  conjugate(): TaggedQuaternion {
    put(this.array);
    return this.#made(called(core.taggedConjugate, this.#code), "the conjugate");
  }

  /**
   * The inverse: the conjugate divided by the square of the norm.
   *
   * @example
   * TaggedQuaternion.of([0, 0, 0, 2], JPL).inverse().array[3]; // 0.5
   */
  inverse(): TaggedQuaternion {
    put(this.array);
    return this.#made(called(core.taggedInverse, this.#code), "the inverse");
  }

  /**
   * The root of the sum of the squares.
   *
   * @example
   * TaggedQuaternion.of([3, 0, 0, 4], JPL).norm(); // 5
   */
  norm(): number {
    put(this.array);
    return called(core.taggedNorm);
  }

  /**
   * With norm 1, each component within one roundoff.
   *
   * @example
   * TaggedQuaternion.of([3, 0, 0, 4], JPL).normalize().array; // [0.6, 0, 0, 0.8]
   */
  normalize(): TaggedQuaternion {
    put(this.array);
    return this.#made(called(core.taggedNormalize, this.#code), "the quaternion");
  }

  /**
   * The same attitude in another convention, with the same norm: the scalar moves, the vector part keeps its
   * signs or changes all three.
   *
   * @example
   * const jpl = TaggedQuaternion.of([0, 0, 0.6, 0.8], JPL);
   * jpl.to(HAMILTON).array; // [0.8, 0, 0, 0.6]: not conjugated, as the directions are opposite too
   * jpl.to(JPL_BODY_TO_WORLD).array[2]; // -0.6
   */
  to(convention: Convention | string): TaggedQuaternion {
    put(this.array);
    const other = TaggedQuaternion.of([0, 0, 0, 1], convention);
    return other.#made(called(core.taggedConvert, this.#code, other.#code), "the quaternion");
  }

  /**
   * The matrix that multiplies another quaternion's array as this one does from a side, row by row.
   *
   * @example
   * // i from the left takes j to k for Hamilton.
   * TaggedQuaternion.of([0, 1, 0, 0], HAMILTON).productMatrix("left")[3][2]; // 1
   * TaggedQuaternion.of([0, 1, 0, 0], HAMILTON).productMatrix("right")[3][2]; // -1
   */
  productMatrix(side: Side): Rows4 {
    const place = sidePlace(side);
    put(this.array);
    settle(called(core.taggedProductMatrix, this.#code, place), "the matrix");
    return rowsOf(registers());
  }

  /**
   * With a small turn: ⊞ on the axes (`perturbation`), on the side and with the sign of the convention.
   *
   * `"physical"` is the turn of the body; `"formal"` leaves out the sign of the convention, as some libraries do.
   *
   * @example
   * const body = TaggedQuaternion.of([0, 0, 0, 1], JPL);
   * body.plus([0.25, 0, 0], "physical").array[0].toFixed(6); // "0.124675"
   * body.to(JPL_BODY_TO_WORLD).plus([0.25, 0, 0], "physical").array[0].toFixed(6); // "-0.124675"
   * body.to(JPL_BODY_TO_WORLD).plus([0.25, 0, 0], "formal").array[0].toFixed(6); // "0.124675"
   */
  plus(incrementRad: Numbers, sign: IncrementSign): TaggedQuaternion {
    const place = signPlace(sign);
    const increment = checkNumbers(incrementRad, 3, "the increment");
    put(this.array);
    put(increment, 4);
    return this.#made(called(core.taggedPlus, this.#code, place), "the quaternion");
  }

  /**
   * The small turn, in radians, that leads from an estimate to this one: ⊟, see `plus`.
   *
   * @example
   * const estimate = TaggedQuaternion.of([0, 0, 0.6, 0.8], JPL);
   * const truth = estimate.plus([0.25, -0.5, 0.125], "physical");
   * truth.minus(estimate, "physical")[1].toFixed(9); // "-0.500000000"
   */
  minus(estimate: TaggedQuaternion, sign: IncrementSign): Vector3 {
    const place = signPlace(sign);
    this.#putBoth(estimate);
    settle(called(core.taggedMinus, this.#code, place), "the difference");
    return [...registers().subarray(0, 3)] as Vector3;
  }

  /**
   * The derivative of the four numbers at an angular velocity of the body, in rad/s, on its own axes or on the
   * world's. It is no rotation.
   *
   * @example
   * // ½ ω ⊗ q for JPL, ½ q ⊙ ω for Hamilton; here q is yawed by 90° and ω about the body's x.
   * const yawed = TaggedQuaternion.of([0, 0, 0.5, 0.5], JPL);
   * yawed.derivative([1, 0, 0], "body"); // [0.25, 0.25, 0, 0]
   * yawed.derivative([1, 0, 0], "world"); // [0.25, -0.25, 0, 0]
   */
  derivative(rateRad: Numbers, axes: RateAxes): Quaternion4 {
    const place = ratePlace(axes);
    const rate = checkNumbers(rateRad, 3, "the rate");
    put(this.array);
    put(rate, 4);
    settle(called(core.taggedDerivative, this.#code, place), "the derivative");
    return [...registers().subarray(0, 4)] as Quaternion4;
  }

  #putBoth(other: TaggedQuaternion): void {
    if (typeof other !== "object" || other === null || !("array" in other)) {
      const hint = "give a TaggedQuaternion, such as TaggedQuaternion.of(array, convention)";
      throw new QuatlasError("wrong-type", `the other is ${kindOf(other)}`, hint);
    }
    if (codeOf(other.convention) !== this.#code) {
      const hint = "convert one of them first, by `to`";
      throw new QuatlasError("mixed-conventions", "the two have different conventions", hint);
    }
    const numbers = checkNumbers(other.array, 4, "the other");
    put(this.array);
    put(numbers, 4);
  }

  #made(outcome: number, what: string): TaggedQuaternion {
    settle(outcome, what);
    const array = [...registers().subarray(0, 4)] as Quaternion4;
    return new TaggedQuaternion(array, this.convention, this.#code);
  }
}

/**
 * The matrix Ω for which the derivative of a convention's array is `½ Ω q`, row by row.
 *
 * @example
 * rateMatrix([1, 2, 3], JPL, "body")[0]; // [0, 3, -2, 1]
 * rateMatrix([1, 2, 3], HAMILTON, "body")[1]; // [1, 0, 3, -2]
 */
export function rateMatrix(
  rateRad: Numbers,
  convention: Convention | string,
  axes: RateAxes,
): Rows4 {
  const code = codeOf(conventionOf(convention));
  const place = ratePlace(axes);
  put(checkNumbers(rateRad, 3, "the rate"));
  settle(called(core.rateMatrix, code, place), "the matrix");
  return rowsOf(registers());
}

function rowsOf(from: Float64Array): Rows4 {
  return [0, 4, 8, 12].map((at) => [...from.subarray(at, at + 4)]) as Rows4;
}
