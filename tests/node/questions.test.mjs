// Questions as people bring them, answered through the package; see `tests/cases/README.md`.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { test } from "node:test";

const quatlas = createRequire(import.meta.url)("../../dist/npm/quatlas.js");
const { between, chain, compose, frames, HAMILTON, HAMILTON_SCALAR_LAST, identify } = quatlas;
const { identifyNumbers, motion, read, swingTwist, translate } = quatlas;
const url = new URL("../cases/questions.json", import.meta.url);
const questions = JSON.parse(readFileSync(url, "utf8"));

/** Of directions nothing is asked yet. */
const notYet = ["tilt-from-gravity"];

const plain = { convention: HAMILTON };
const vector = "1 0 0";
const zyx = { axes: "zyx", frame: "intrinsic" };
const library = (id) => ({ kind: "library", id });
const apart = (p, q) => between({ p, q, ...plain }).local.angleDeg;
/** In the order in which a program prints roll, pitch and yaw. */
const reversed = (numbers) => [...numbers].reverse();
const rpyDeg = (text) =>
  reversed(read({ quaternion: text, vector, euler: zyx, ...plain }).euler.anglesDeg);

const answers = {
  "order-from-a-matrix": () => {
    const numbers = [0.93120417, -0.2215999, 0.28939987, 0];
    const printed = [
      [0.832495, -0.128262, 0.538981],
      [-0.128262, 0.901787, 0.412709],
      [-0.538981, -0.412709, 0.734282],
    ];
    const { remaining } = identify({
      observations: [{ probe: "matrix", quaternion: numbers, printed, layout: "as-written" }],
    });
    const first = read({ quaternion: numbers, vector, ...plain });
    const last = read({ quaternion: numbers, vector, convention: HAMILTON_SCALAR_LAST });
    return {
      order: remaining.constructor.join(),
      angleDeg: first.turn.angleDeg,
      betweenDeg: apart(first.hamilton.unit.array, last.hamilton.unit.array),
    };
  },
  "which-sequences-two-programs": () => {
    const quaternion = "w=0.77781 x=-0.52878 y=-0.19588 z=0.27755";
    const sequenceOf = (numbers) => {
      const { decides, readings } = identifyNumbers({ numbers, quaternion, ...plain });
      assert.ok(decides, numbers);
      return readings[0].meaning.sequence;
    };
    // About fixed axes it is the same as about moving ones in reverse.
    const moving = ({ axes, frame }) =>
      frame === "intrinsic"
        ? { axes, frame }
        : { axes: [...axes].reverse().join(""), frame: "intrinsic" };
    const name = ({ axes, frame }) => `${axes} ${frame}`;
    const degrees = (euler) => read({ quaternion, vector, euler, ...plain }).euler.anglesDeg;
    const first = moving(sequenceOf("-68.65, -0.64, 39.71"));
    const second = moving(sequenceOf("314.45, 301.32, 65.83"));
    return {
      first: name(first),
      zyxDeg: degrees(first),
      second: name(second),
      yxzDeg: degrees(second),
    };
  },
  "two-programs-opposite-angles": () => {
    const q = "0.494 -0.352 0.785 -0.124";
    const euler = { axes: "xyz", frame: "intrinsic" };
    const conjugated = chain({ factors: [{ text: q, inverse: true }], euler: zyx, ...plain });
    return {
      xyzIntrinsicOfQ: read({ quaternion: q, vector, euler, ...plain }).euler.anglesDeg,
      rollPitchYawOfConjugate: reversed(conjugated.euler.anglesDeg),
      rollPitchYawOfQ: rpyDeg(q),
    };
  },
  "two-triples-one-attitude": () => {
    const two = { p: "rpy 76.41837 -8.21011 33.69479 deg", q: "rpy -103.582 -171.79 -146.305 deg" };
    assert.equal(between({ ...two, ...plain }).verdict, "equal");
    return { apartDeg: apart(two.p, two.q) };
  },
  "camera-centre": () => {
    const { answer } = frames({
      poses: [
        {
          parent: "camera",
          child: "world",
          rotation: "0.496224075 -0.330001337 -0.763643223 -0.248414597",
          position: "1.800564 -2.70038 -0.763124",
        },
      ],
      child: "camera",
      parent: "world",
      ...plain,
    });
    return { centre: answer.position };
  },
  "camera-to-camera": () => {
    const cam0 = [
      [-0.515614, -0.825047, 0.23117, 0.1689],
      [0.72452, -0.563857, -0.396403, 0.1242],
      [0.457399, -0.036904, 0.888496, 0.0505],
      [0, 0, 0, 1],
    ];
    const cam1 = [
      [0.622345, -0.372651, 0.688344, 0.1523],
      [-0.753767, -0.048262, 0.655367, -0.0927],
      [-0.211002, -0.926716, -0.310927, 0.0331],
      [0, 0, 0, 1],
    ];
    const { answer } = frames({
      poses: [
        { parent: "cam0", child: "imu", rotation: cam0 },
        { parent: "cam1", child: "imu", rotation: cam1 },
      ],
      child: "cam0",
      parent: "cam1",
      ...plain,
    });
    return { rotation: answer.hamilton.matrix, translation: answer.position };
  },
  "first-and-then": () => {
    const { products } = compose({ p: "180deg about y", q: "90deg about z", vector, ...plain });
    const imageOf = (left) =>
      products.find((of) => of.left === left && of.convention.handedness === "right").images[1];
    return { q1q2: imageOf("p"), q2q1: imageOf("q") };
  },
  "two-arcs-and-one": () => {
    const [a, b, c] = [
      "45deg about z",
      "atan(1/√2) rad about 1 -1 0",
      "acos(1/√3) rad about 0 -1 1",
    ];
    const product = chain({ factors: [{ text: b }, { text: a }], ...plain });
    const ba = product.declared.unit.array;
    const { global } = between({ p: c, q: ba, ...plain });
    const { axis, angleDeg } = global;
    const wanted = read({ quaternion: c, vector, ...plain }).hamilton.unit.array;
    return {
      ba,
      c: wanted,
      differenceDeg: angleDeg,
      axis: axis[0] < 0 ? axis.map((n) => -n) : axis,
    };
  },
  "row-times-matrix": () => {
    const asked = { quaternion: "40deg about y", vector: "0 0 1", ...plain };
    const { hamilton, jpl } = read(asked);
    return { row: jpl.image, column: hamilton.image };
  },
  "comment-says-urdf": () => {
    const q = "x=-0.700565 y=0.452149 z=-0.533382 w=0.142381";
    const beside = identifyNumbers({
      numbers: "2.514692 1.067699 1.524884",
      quaternion: q,
      ...plain,
    });
    assert.deepEqual(beside.readings[0].meaning.sequence, { axes: "xyz", frame: "intrinsic" });
    return {
      apartDeg: apart(q, "rpy 2.514692 1.067699 1.524884 rad"),
      urdfRpy: reversed(read({ quaternion: q, vector, euler: zyx, ...plain }).euler.anglesRad),
    };
  },
  "two-names-at-the-lock": () => {
    const [first, second, third] = ["60 -90 15", "0 -90 75", "15 -90 15"].map(
      (n) => `rpy ${n} deg`,
    );
    const sumOf = (text) => {
      const [roll, , yaw] = rpyDeg(text);
      return roll + yaw;
    };
    return {
      sumDeg: [first, second, third].map(sumOf),
      apartDeg: [apart(first, second), apart(first, third)],
    };
  },
  "flip-near-the-lock": () => {
    const off = apart("rpy 0 pi/2-1e-9 0.4 rad", "rpy pi pi/2 0.4-pi rad");
    assert.ok(off > 0);
    return { apartDegBelow: off };
  },
  "slerp-the-short-way": () => {
    const a = "0.194132737 -0.727670469 -0.560579684 -0.344323376";
    const b = "-0.267723823 0.663392496 0.560265008 0.41753739";
    const { way, local } = between({ p: a, q: b, part: "0.3", ...plain });
    const short = way.unit.array;
    // The other way round, of which 0.3 is as far.
    const back = (-0.3 * (360 - local.angleDeg)) / local.angleDeg;
    const long = between({ p: a, q: b, part: String(back), ...plain }).way.unit.array;
    return { short, long, fromADeg: apart(a, short), wholeDeg: local.angleDeg };
  },
  "mean-of-two-signs": () => {
    const [a, b] = ["0.984808 0.173648 0 0", "-0.906308 -0.422618 0 0"];
    const { mean } = chain({ factors: [{ text: a }, { text: b }], ...plain });
    // 10° and 25°, of which the numbers that are given are the cosine and the sine.
    const [ten, more] = [10, 25].map((degrees) => (degrees * Math.PI) / 180);
    const ofNumbers = [Math.cos(ten) - Math.cos(more), Math.sin(ten) - Math.sin(more), 0, 0];
    return { mean: mean.array, ofNumbersDegAway: apart("35deg about x", ofNumbers) };
  },
  "rate-of-two-attitudes": () => {
    const asked = { p: "1 0 0 0", q: "60deg about x", duration: "0.25 s", ...plain };
    return { rate: between(asked).rate.bodyRad };
  },
  "covariance-in-another-frame": () => {
    const covariance = [
      [0.4, 0.1, -0.2],
      [0.1, 0.9, 0.3],
      [-0.2, 0.3, 0.6],
    ];
    const told = motion({ quaternion: "90deg about y", covariance, ...plain });
    return { covariance: told.covariance.world };
  },
  "small-turn-local-or-global": () => {
    const asked = { quaternion: "40deg about z", increment: "0 0.02 0" };
    const { plus, worldRad } = motion({ ...asked, ...plain }).increment;
    const global = motion({ ...asked, convention: { ...HAMILTON, perturbation: "global" } });
    return {
      local: plus[0].quaternion.array,
      global: global.increment.plus.find(({ convention }) => convention.perturbation === "global")
        .quaternion.array,
      inWorld: worldRad,
    };
  },
  "jpl-numbers-in-eigen": () => {
    const { to } = translate({
      quaternion: "-0.252501 -0.487566 -0.821289 0.154945",
      from: library("openvins"),
      to: library("eigen"),
    });
    assert.deepEqual(to.array, [-0.252501, -0.487566, -0.821289, 0.154945]);
    return { R_ItoG: to.matrix.rows };
  },
  "camera-on-a-body": () => {
    const factors = [
      { text: "0.4952 -0.283 -0.15426 0.80678" },
      { text: "yaw 90 pitch -30 roll 0 deg" },
    ];
    return { quaternion: chain({ factors, ...plain }).declared.unit.array };
  },
  "heading-without-tilt": () => {
    const asked = { quaternion: "yaw 65 pitch 20 roll -35 deg", axis: "z", ...plain };
    const { twistDeg, swing } = swingTwist(asked);
    return { twistDeg, swingDeg: swing.angleDeg };
  },
  "integrate-constant-rate": () => {
    const { path } = motion({
      quaternion: "0.15344 -0.26001 -0.73431 0.60799",
      rate: "0.6 -0.9 1.4 rad/s",
      duration: "0.4 s",
      steps: 1,
      ...plain,
    });
    const ofAdding = path.integrators[3].find(([steps]) => steps === 1);
    return { quaternion: path.end.array, eulerStepOffDeg: (ofAdding[2] * 180) / Math.PI };
  },
  "nearest-rotation": () => {
    const quaternion =
      "[[0.6341, 0.3822, 0.6756], [-0.0640, 0.8915, -0.4600], [-0.7780, 0.2446, 0.5906]]";
    const report = read({ quaternion, vector, ...plain });
    const note = report.notes.find(({ fact }) => fact.kind === "nearest-rotation");
    return { quaternion: report.hamilton.unit.array, frobenius: note.fact.correction };
  },
  "kuka-to-ur": () => {
    const { to } = translate({
      quaternion: "A -118.4 B 21.3 C 76.9",
      from: library("kuka-abc"),
      to: library("ur-rotvec"),
    });
    assert.equal(to.numbers.unit, "radians");
    return { rotationVector: to.numbers.values };
  },
};

const quaternions = ["ba", "c", "short", "long", "mean", "local", "global", "quaternion"];

/** Within the tolerance; of a quaternion up to the sign. */
function expectClose(name, got, wanted, tolerance) {
  if (typeof wanted === "string") return assert.equal(got, wanted, name);
  if (name.endsWith("Below")) return assert.ok(got < wanted, `${name}: ${got}`);
  const [numbers, expected] = [[got].flat(2), [wanted].flat(2)];
  const off = (sign) => Math.max(...expected.map((n, at) => Math.abs(n - sign * numbers[at])));
  const least = quaternions.includes(name) ? Math.min(off(1), off(-1)) : off(1);
  assert.ok(least <= tolerance, `${name}: ${numbers} for ${expected}`);
}

for (const { id, question, answer } of questions) {
  if (notYet.includes(id)) continue;
  test(`${id}: ${question}`, () => {
    const told = answers[id]();
    assert.deepEqual(Object.keys(told).sort(), Object.keys(answer.numbers).sort());
    for (const [name, number] of Object.entries(told)) {
      expectClose(name, number, answer.numbers[name], answer.tolerance);
    }
  });
}

test("every question is answered, or known not to be yet", () => {
  assert.deepEqual(
    questions.map(({ id }) => id).filter((id) => answers[id] === undefined),
    notYet,
  );
});
