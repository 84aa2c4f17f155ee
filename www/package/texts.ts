// What the package answers about texts, whichever way its core came.
import type {
  AtlasReport,
  AtlasRequest,
  BetweenReport,
  BetweenRequest,
  ChainReport,
  ChainRequest,
  ComposeReport,
  ComposeRequest,
  FramesReport,
  FramesRequest,
  IdentifyReport,
  IdentifyRequest,
  MatricesReport,
  MatricesRequest,
  MotionReport,
  MotionRequest,
  NumbersReport,
  NumbersRequest,
  Outcome,
  Problems,
  ReadReport,
  ReadRequest,
  Request,
  SwingTwistReport,
  SwingTwistRequest,
  TranslateReport,
  TranslateRequest,
} from "../../pkg/quatlas.js";
import { answer } from "./core.ts";

/**
 * The answer to a request: a report with notes, or the problems of its texts.
 *
 * What is typed never throws: a text that cannot be read comes back as `status: "problems"`, each
 * with a code, a span in UTF-16 units, what was expected and what to try. Every text may also be a
 * number, a list of them (an array or a `Float64Array`) or rows of them: they are read as they would be
 * typed, `[0, 0, 0.6, 0.8]`, and a span points into that. A `TypeError` says that
 * the request is not of its type: a member that is missing, of another kind, or not known. What a
 * getter of the request throws is passed on.
 *
 * @example
 * // x y z w of a JPL filter, world to body: a quarter turn about z
 * const outcome = analyze({ view: "read", quaternion: "0 0 √½ √½", vector: "1 0 0", convention: JPL });
 * outcome.jpl.image; // [0, -1, 0]: the world's x axis lies along the body's −y
 */
export function analyze(request: Request): Outcome {
  return answer(request);
}
/**
 * One attitude, from one library or convention to another: the numbers at both ends, what was done to
 * them, the matrices, the lines of code, and what goes wrong if a step is forgotten.
 *
 * What is typed never throws, see `analyze`.
 *
 * @example
 * // A JPL filter to SciPy: the customary directions are opposite, so nothing is conjugated.
 * const translated = translate({
 *   quaternion: "0 0 0.6 0.8",
 *   from: { kind: "library", id: "openvins" },
 *   to: { kind: "library", id: "scipy-scalar-first" },
 * });
 * translated.to.array; // [0.8, 0, 0, 0.6]
 * translated.change; // "reordered"
 */
export function translate(
  request: TranslateRequest,
): ({ status: "translate" } & TranslateReport) | ({ status: "problems" } & Problems) {
  return answer(request, "translate") as ReturnType<typeof translate>;
}

/**
 * Which convention a library uses, from what it printed, and what to try next.
 *
 * It always answers: a text that cannot be read is a problem in the report, at its observation.
 *
 * @example
 * const report = identify({
 *   observations: [{ probe: "product", a: "0 1 0 0", b: "0 0 1 0", printed: "0 0 0 -1" }],
 * });
 * report.settled; // ["constructor", "array", "handedness"]
 * report.remaining.handedness; // ["left"]: i*j = -k
 * report.next.code; // "print(Quaternion(0.5, 0.5, 0.5, 0.5).rotate([1, 2, 3]))"
 */
export function identify(request: IdentifyRequest): IdentifyReport {
  const { status: _, ...report } = answer(request, "identify") as {
    status: "identify";
  } & IdentifyReport;
  return report;
}

/**
 * Which description of an attitude three, four or nine numbers are, or the problems of either text.
 *
 * Three are Euler angles in one of 24 sequences, in degrees or radians and in any order, or a vector along
 * the axis; four a quaternion and nine a matrix, perhaps transposed, scaled, reflected or on other axes.
 * Four names of components, `(-q2, q1, -q4, q3)`, are the rewriting of any quaternion. So an unknown
 * function of three angles is told by one matrix that it made: of 30 20 10 no two readings are nearer to
 * each other than 2.7°.
 *
 * @example
 * // A game engine prints x, y, z from 0 to 360, and turns about y, x and z, which move.
 * const { readings, decides } = identifyNumbers({
 *   numbers: "314.45, 301.32, 65.83",
 *   quaternion: "w=0.77781 x=-0.52878 y=-0.19588 z=0.27755",
 *   convention: HAMILTON,
 * });
 * decides; // true: no other reading fits
 * readings[0].meaning.sequence; // { axes: "yxz", frame: "intrinsic" }
 * readings[0].meaning.turnsAbout; // ["x", "y", "z"]
 * readings[0].text; // "YXZ 301.32 314.45 65.83 deg"
 */
export function identifyNumbers(
  request: NumbersRequest,
): ({ status: "numbers" } & NumbersReport) | ({ status: "problems" } & Problems) {
  return answer(request, "numbers") as ReturnType<typeof identifyNumbers>;
}

/**
 * What a library of rotation matrices means, from what it printed; what is not told is left out.
 *
 * What is typed never throws, see `analyze`.
 *
 * @example
 * // The matrix of a body that was turned by +90° about the world's z axis.
 * const { operator } = identifyMatrices({ yawed: "[[0, 1, 0], [-1, 0, 0], [0, 0, 1]]" });
 * operator; // "world-to-body"
 */
export function identifyMatrices(
  request: MatricesRequest,
): ({ status: "matrices" } & MatricesReport) | ({ status: "problems" } & Problems) {
  return answer(request, "matrices") as ReturnType<typeof identifyMatrices>;
}

/**
 * What one attitude means: its numbers in the declared convention, as Hamilton and as JPL, the matrix, the
 * turn and the Euler angles.
 *
 * What is typed never throws, see `analyze`.
 *
 * @example
 * // x y z w of a JPL filter, world to body: a quarter turn about z
 * const { jpl, hamilton } = read({ quaternion: "0 0 √½ √½", vector: "1 0 0", convention: JPL });
 * jpl.image; // [0, -1, 0]: the world's x axis lies along the body's −y
 * hamilton.image; // [0, 1, 0]: and the body's x axis along the world's y
 */
export function read(
  request: ReadRequest,
): ({ status: "read" } & ReadReport) | ({ status: "problems" } & Problems) {
  return answer(request, "read") as ReturnType<typeof read>;
}

/**
 * What two attitudes make together: p∘q in the declared convention, and both products in both orders.
 *
 * What is typed never throws, see `analyze`.
 *
 * @example
 * // i and j: ij = k in Hamilton's product, and −k in JPL's
 * const { products } = compose({ p: "i", q: "j", vector: "1 0 0", convention: HAMILTON });
 * products[0].quaternion.z; // 1: of p ⊙ q
 * products[2].quaternion.z; // -1: of p ⊗ q
 */
export function compose(
  request: ComposeRequest,
): ({ status: "compose" } & ComposeReport) | ({ status: "problems" } & Problems) {
  return answer(request, "compose") as ReturnType<typeof compose>;
}

/**
 * How two attitudes differ: what the texts are to each other, the turn from p to q on the axes of the body
 * and of the world, the error quaternion with its side, three distances, the way from one to the other, and
 * the rate that leads there in a given time.
 *
 * What is typed never throws, see `analyze`.
 *
 * @example
 * // The log of one program beside that of another, which has the scalar last.
 * const { verdict } = between({ p: "0.5 0.1 0.7 0.5", q: "0.1 0.7 0.5 0.5", convention: HAMILTON });
 * verdict; // "scalar-moved"
 *
 * // An estimate and the truth, a quarter of the way: 20° of 80° about z, on the axes of the body.
 * const { local, way, jpl } = between({
 *   p: "10deg about z",
 *   q: "90deg about z",
 *   convention: HAMILTON,
 *   part: "1/4",
 * });
 * Math.round(local.angleDeg); // 80
 * Math.round(2 * Math.acos(way.unit.w) * (180 / Math.PI)); // 30
 * jpl.rules.increment; // "left": q = δq ⊗ p
 *
 * // The gyroscope between two attitudes that are 250 ms apart, in rad/s.
 * const { rate } = between({ p: "1 0 0 0", q: "60deg about x", convention: HAMILTON, duration: "250 ms" });
 * rate.bodyRad[0].toFixed(4); // "4.1888", and not the half of it
 */
export function between(
  request: BetweenRequest,
): ({ status: "between" } & BetweenReport) | ({ status: "problems" } & Problems) {
  return answer(request, "between") as ReturnType<typeof between>;
}

/**
 * The product of up to 32 attitudes, from left to right in the declared convention, each as it is or
 * inverted, and the attitude in the middle of them.
 *
 * What is typed never throws, see `analyze`. A problem of a factor tells its place in `at`.
 *
 * @example
 * // A camera on a body: where it points, from the body in the world and the camera on the body.
 * const { turn, jpl } = chain({
 *   factors: [{ text: "30deg about z" }, { text: "10deg about z", inverse: true }],
 *   convention: HAMILTON,
 * });
 * Math.round(turn.angleDeg); // 20
 * jpl.rules.operator; // "world-to-body": there the factors stand in reverse, and none is conjugated
 */
export function chain(
  request: ChainRequest,
): ({ status: "chain" } & ChainReport) | ({ status: "problems" } & Problems) {
  return answer(request, "chain") as ReturnType<typeof chain>;
}

/**
 * One attitude in the 8 conventions of product, function and direction, each in both orders: which of these
 * arrays is mine, and what does it multiply on which side?
 *
 * What is typed never throws, see `analyze`.
 *
 * @example
 * const { rows, sameAs } = atlas({ quaternion: "0.8 0 0 0.6", convention: HAMILTON });
 * rows[4].convention.handedness; // "left": JPL's product, body to world
 * rows[4].quaternion.array; // [0.8, 0, 0, -0.6]: the conjugate
 * sameAs[5]; // 0: JPL, world to body, has Hamilton's numbers
 */
export function atlas(
  request: AtlasRequest,
): ({ status: "atlas" } & AtlasReport) | ({ status: "problems" } & Problems) {
  return answer(request, "atlas") as ReturnType<typeof atlas>;
}

/**
 * One attitude as a turn about an axis and a swing that has none: heading and tilt.
 *
 * What is typed never throws, see `analyze`.
 *
 * @example
 * // The heading is not the yaw angle where the body is tilted.
 * const { twistDeg, swing } = swingTwist({
 *   quaternion: "yaw 65 pitch 20 roll -35 deg",
 *   axis: "z",
 *   convention: HAMILTON,
 * });
 * twistDeg.toFixed(2); // "71.36"
 * swing.angleDeg.toFixed(2); // "39.67"
 */
export function swingTwist(
  request: SwingTwistRequest,
): ({ status: "swing-twist" } & SwingTwistReport) | ({ status: "problems" } & Problems) {
  return answer(request, "swing-twist") as ReturnType<typeof swingTwist>;
}

/**
 * Where one frame stands in another, from what is known between named frames: the path and its poses, the
 * answer in Hamilton's and JPL's product, the point that is asked for in every frame, and the loops that
 * do not close.
 *
 * A pose takes coordinates in its child to coordinates in its parent, and so does the answer; any of them may be
 * given the other way round. It always answers: what cannot be read is a problem in the report, at its pose.
 *
 * @example
 * // A camera on a body that stands at (5, 0, 0), turned by 90° about z; the JPL filter writes G to I.
 * const { answer, path } = frames({
 *   poses: [
 *     { parent: "G", child: "I", rotation: "0 0 √½ √½", position: [5, 0, 0] },
 *     { parent: "C", child: "I", rotation: "0 0 0 1", position: [0, 0, -1] },
 *   ],
 *   child: "C",
 *   parent: "G",
 *   convention: JPL,
 * });
 * answer.position; // [5, 0, 1]
 * answer.hamilton.matrix[1][0]; // 1: the axis x of the camera lies along y of G
 * path; // [{ pose: 0, inverted: false, frame: 1 }, { pose: 1, inverted: true, frame: 2 }]
 */
export function frames(request: FramesRequest): FramesReport {
  const { status: _, ...report } = answer(request, "frames") as {
    status: "frames";
  } & FramesReport;
  return report;
}

/**
 * What moves an attitude: a small turn in every convention, the derivatives at an angular velocity, and the
 * path over time, with the integrators compared and what goes wrong. What is not given is not answered.
 *
 * Rates are right-handed, of the body against the world, in rad/s where no unit is written. What is typed
 * never throws, see `analyze`.
 *
 * @example
 * // A gyroscope about the body's x, of a body that is yawed by a quarter turn; JPL.
 * const { derivative, path } = motion({
 *   quaternion: [0, 0, Math.SQRT1_2, Math.SQRT1_2],
 *   convention: JPL,
 *   rate: "90 0 0 deg/s",
 *   duration: "1 s",
 * });
 * derivative.quaternions[0].side; // "left": ½ ω ⊗ q
 * derivative.worldRad[1]; // 1.5708: about the world's y
 * path.end.array; // [0.5, 0.5, 0.5, 0.5]
 * Math.round(path.mistakes[0].angleDeg); // 120: the rate on the other side
 *
 * // A small turn of the body, which Hamilton multiplies on the right.
 * const { increment } = motion({ quaternion: "1 0 0 0", convention: HAMILTON, increment: "1 0 0 deg" });
 * increment.plus[0].side; // "right": q ⊙ δq
 * increment.plus[0].quaternion.x; // 0.0087265
 *
 * // The variances of a body turned by 90° about y, on the axes of the world: its z is the world's x.
 * const { covariance } = motion({
 *   quaternion: "90 deg about y",
 *   convention: HAMILTON,
 *   covariance: [1, 4, 9],
 * });
 * Math.round(covariance.world[0][0]); // 9
 */
export function motion(
  request: MotionRequest,
): ({ status: "motion" } & MotionReport) | ({ status: "problems" } & Problems) {
  return answer(request, "motion") as ReturnType<typeof motion>;
}
