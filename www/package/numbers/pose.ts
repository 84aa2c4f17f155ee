// A frame in another: an attitude and a position.
import type { Direction } from "../../../pkg/quatlas.js";
import { QuatlasError } from "../quatlas_error.ts";
import type { RotationLike } from "./attitude.ts";
import {
  checkNumbers,
  kindOf,
  type Numbers,
  type Quaternion4,
  type Rows3,
  type Vector3,
} from "./checks.ts";
import { directionPlace } from "./choices.ts";
import { Rotation } from "./rotation.ts";

/** What a pose is made of. */
export interface PoseParts {
  /** From the child's axes to the parent's. */
  rotation: RotationLike;
  /** The origin of the child, in coordinates of the parent. */
  position: Numbers;
  /** What the frames are called; named ones have to meet. */
  parent?: string;
  child?: string;
}

/** Four rows of a homogeneous matrix. */
export type PoseRows = [Quaternion4, Quaternion4, Quaternion4, Quaternion4];

/**
 * Where a frame stands in another, a frozen value: `x_P = R_PC x_C + p`.
 *
 * The child may be a body and the parent the world; frames may have names, and then only those that meet are put
 * together.
 *
 * @example
 * // A body at (5, 0, 0), yawed by 90°, and a camera one metre ahead of it.
 * const yawed = Rotation.fromAxisAngle([0, 0, 1], 90, "deg");
 * const body = Pose.of({ rotation: yawed, position: [5, 0, 0], parent: "world", child: "body" });
 * const ahead = Rotation.identity();
 * const camera = Pose.of({ rotation: ahead, position: [1, 0, 0], parent: "body", child: "camera" });
 * body.andThen(camera).position; // [5, 1, 0]
 */
export class Pose {
  static {
    // A console calls it so, also where a bundler has given it another name.
    Object.defineProperty(Pose, "name", { value: "Pose" });
  }

  /** From the child's axes to the parent's. */
  readonly rotation: Rotation;
  /** The origin of the child, in coordinates of the parent. */
  readonly position: Readonly<Vector3>;
  readonly parent: string | undefined;
  readonly child: string | undefined;

  private constructor(
    rotation: Rotation,
    position: Vector3,
    parent: string | undefined,
    child: string | undefined,
  ) {
    this.rotation = rotation;
    this.position = Object.freeze(position);
    this.parent = parent;
    this.child = child;
    Object.freeze(this);
  }

  /**
   * The pose of a rotation and a position.
   *
   * @example
   * const rotation = Rotation.fromQuat([0, 0, Math.SQRT1_2, Math.SQRT1_2], JPL);
   * Pose.of({ rotation, position: [0, 0, 2] }).apply([1, 0, 0]); // [0, 1, 2]
   */
  static of({ rotation, position, parent, child }: PoseParts): Pose {
    const origin = checkNumbers(position, 3, "the position");
    return new Pose(Rotation.from(rotation), vectorOf(origin), nameOf(parent), nameOf(child));
  }

  /**
   * The pose of a homogeneous matrix that multiplies columns, given by its four rows, or by the first three.
   *
   * `"body-to-world"` takes coordinates in the child to coordinates in the parent. Its rotation is checked as by
   * `Rotation.fromMatrix`.
   *
   * @example
   * const rows = [[0, -1, 0, 5], [1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]];
   * Pose.fromMatrix(rows, "body-to-world").position; // [5, 0, 0]
   * Pose.fromMatrix(rows, "world-to-body").position[1].toFixed(9); // "5.000000000"
   */
  static fromMatrix(rows: readonly Numbers[], direction: Direction): Pose {
    const isInverse = directionPlace(direction) === 1;
    if (!Array.isArray(rows) || rows.length < 3 || rows.length > 4) {
      const hint = "give four rows of four numbers, or the first three";
      throw new QuatlasError("wrong-count", `the matrix is ${kindOf(rows)}`, hint);
    }
    const checked = rows.map((row, at) => checkNumbers(row, 4, `row ${at} of the matrix`, at));
    const last = checked[3];
    if (last !== undefined && [...last].some((entry, at) => entry !== (at === 3 ? 1 : 0))) {
      const hint =
        "its last row has to be 0 0 0 1; a matrix for row vectors has to be transposed first";
      throw new QuatlasError("not-a-rotation", "the matrix is no pose", hint);
    }
    const upper = checked.slice(0, 3);
    const rotation = Rotation.fromMatrix(
      upper.map((row) => row.slice(0, 3)),
      "body-to-world",
    );
    const position = upper.map((row) => row[3]) as Vector3;
    const pose = new Pose(rotation, position, undefined, undefined);
    return isInverse ? pose.inv() : pose;
  }

  /**
   * The pose of the child of another in the parent of this one: `T_WB.andThen(T_BC)` is `T_WC`.
   *
   * A `QuatlasError`, `frames-do-not-meet`, where both name the frame between and the names differ.
   *
   * @example
   * const turn = Rotation.fromAxisAngle([0, 0, 1], 90, "deg");
   * const step = Pose.of({ rotation: turn, position: [1, 0, 0] });
   * step.andThen(step).position; // [1, 1, 0]
   */
  andThen(next: Pose): Pose {
    if (!(next instanceof Pose)) {
      throw new QuatlasError("wrong-type", `the next is ${kindOf(next)}`, "give a Pose");
    }
    const { child } = this;
    if (child !== undefined && next.parent !== undefined && child !== next.parent) {
      const message = `this pose ends at ${child} and the next one begins at ${next.parent}`;
      throw new QuatlasError(
        "frames-do-not-meet",
        message,
        "turn one around by `inv`, or take another",
      );
    }
    const rotation = this.rotation.andThen(next.rotation);
    return new Pose(rotation, this.apply(next.position), this.parent, next.child);
  }

  /**
   * Where the parent stands in the child.
   *
   * @example
   * const yawed = Rotation.fromAxisAngle([0, 0, 1], 90, "deg");
   * Pose.of({ rotation: yawed, position: [5, 0, 0] }).inv().position; // [0, 5, 0]
   */
  inv(): Pose {
    const [x, y, z] = this.rotation.applyInverse(this.position);
    // From zero, so that no coordinate is −0.
    const position: Vector3 = [0 - x, 0 - y, 0 - z];
    return new Pose(this.rotation.inv(), position, this.child, this.parent);
  }

  /**
   * A point in coordinates of the child, in those of the parent.
   *
   * @example
   * const yawed = Rotation.fromAxisAngle([0, 0, 1], 90, "deg");
   * Pose.of({ rotation: yawed, position: [5, 0, 0] }).apply([1, 0, 0]); // [5, 1, 0]
   */
  apply(point: Numbers): Vector3 {
    const [x, y, z] = this.rotation.apply(point);
    const [px, py, pz] = this.position;
    return vectorOf(checkNumbers([x + px, y + py, z + pz], 3, "the point"));
  }

  /**
   * A point in coordinates of the parent, in those of the child.
   *
   * @example
   * const yawed = Rotation.fromAxisAngle([0, 0, 1], 90, "deg");
   * Pose.of({ rotation: yawed, position: [5, 0, 0] }).applyInverse([5, 1, 0]); // [1, 0, 0]
   */
  applyInverse(point: Numbers): Vector3 {
    const [x = 0, y = 0, z = 0] = checkNumbers(point, 3, "the point");
    const [px, py, pz] = this.position;
    return this.rotation.applyInverse([x - px, y - py, z - pz]);
  }

  /**
   * The homogeneous matrix that multiplies columns, row by row.
   *
   * @example
   * const yawed = Rotation.fromAxisAngle([0, 0, 1], 90, "deg");
   * const pose = Pose.of({ rotation: yawed, position: [5, 0, 0] });
   * pose.asMatrix("body-to-world")[0]; // [0, -1, 0, 5]
   * pose.asMatrix("world-to-body")[1]; // [-1, 0, 0, 5]
   */
  asMatrix(direction: Direction): PoseRows {
    const { rotation, position } = directionPlace(direction) === 1 ? this.inv() : this;
    const rows: Rows3 = rotation.asMatrix("body-to-world");
    const [x, y, z] = position;
    return [
      [...rows[0], x],
      [...rows[1], y],
      [...rows[2], z],
      [0, 0, 0, 1],
    ];
  }
}

function nameOf(value: unknown): string | undefined {
  if (value === undefined || typeof value === "string") return value;
  throw new QuatlasError("wrong-type", `the name of a frame is ${kindOf(value)}`, "give a text");
}

function vectorOf(numbers: Numbers): Vector3 {
  const [x = 0, y = 0, z = 0] = numbers;
  return [x, y, z];
}
