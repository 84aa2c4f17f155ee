// What the package answers of two attitudes, of many, and of one in all conventions, to the golden numbers.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { test } from "node:test";
import { fileURLToPath } from "node:url";

const root = fileURLToPath(new URL("../..", import.meta.url));
const quatlas = createRequire(import.meta.url)("../../dist/npm/quatlas.js");
const { atlas, between, chain, compose, HAMILTON, HAMILTON_SCALAR_LAST, JPL, read, swingTwist } =
  quatlas;
const golden = JSON.parse(readFileSync(`${root}/tests/vectors/golden.json`, "utf8")).cases;
const outputOf = (id) => golden.find((of) => of.id === id).output;

const a = "rotvec 0.4 -0.7 1.1";
const b = "rotvec -0.6 0.25 0.9";

function close(got, wanted, tolerance = 4e-15) {
  const numbers = [got].flat(2);
  const expected = [wanted].flat(2);
  assert.equal(numbers.length, expected.length);
  for (const [at, number] of numbers.entries()) {
    const off = Math.abs(number - expected[at]);
    assert.ok(off <= tolerance * Math.max(1, Math.abs(expected[at])), `${numbers} is ${expected}`);
  }
}

test("the distances of G27, the turn on both sets of axes, and half way", () => {
  const report = between({ p: a, q: b, convention: HAMILTON });
  const wanted = outputOf("G27");
  close(report.local.angleRad, wanted.geodesic);
  close(report.chordalDistance, wanted.chordal);
  close(report.quaternionDistance, wanted.quaternion);
  close(report.negatedQuaternionDistance, wanted.quaternion_second_negated);
  close(report.local.rotationVectorRad, [-0.38744, 1.273941, -0.064952], 5e-7);
  close(report.global.rotationVectorRad, [-1.243625, 0.30896, -0.367691], 5e-7);
  close(report.halfway.unit.array, [0.860461, -0.052897, -0.108373, 0.49504], 5e-7);
  assert.equal(report.verdict, "different");
  // The error quaternion has the same numbers in both conventions, on opposite sides.
  const sides = [report.hamilton, report.jpl].map(({ rules }) => rules.increment);
  assert.deepEqual(sides, ["right", "left"]);
  assert.deepEqual(report.hamilton.unit.array, [
    report.jpl.unit.array[3],
    ...report.jpl.unit.array.slice(0, 3),
  ]);
  const { eulerDifferencesDeg } = between({
    p: "yaw 359 pitch 0 roll 0 deg",
    q: "yaw 1 pitch 0 roll 0 deg",
    convention: JPL,
  });
  close(eulerDifferencesDeg, [2, 0, 0], 1e-13);
});

test("the rate between two attitudes, and the half that is forgotten", () => {
  const asked = { p: "1 0 0 0", q: "60deg about x", convention: HAMILTON };
  const { rate } = between({ ...asked, duration: "250 ms" });
  close(rate.bodyRad, [4.18879, 0, 0], 1e-6);
  assert.equal(rate.durationS, 0.25);
  assert.equal(rate.mistakes[0].kind, "half-forgotten");
  close(rate.mistakes[0].angleDeg, 30, 1e-13);
  assert.equal(between(asked).rate, undefined);
  const { problems } = between({ ...asked, duration: "0" });
  assert.deepEqual([problems[0].field, problems[0].code], ["duration", "out-of-bounds"]);
});

test("the product of G25, its inverse, and the mean", () => {
  const report = chain({ factors: [{ text: a }, { text: b }], convention: HAMILTON });
  const wanted = outputOf("G25");
  close(report.turn.rotationVectorRad, wanted.v);
  close(report.hamilton.matrix, wanted.R);
  const inverse = chain({
    factors: [
      { text: b, inverse: true },
      { text: a, inverse: true },
    ],
    convention: HAMILTON,
  });
  close(inverse.declared.unit.array, report.declared.inverse.array);
  const { mean } = chain({
    factors: [{ text: "0.984808 0.173648 0 0" }, { text: "-0.906308 -0.422618 0 0" }],
    convention: HAMILTON,
  });
  close(mean.array, [0.953717, 0.300706, 0, 0], 2e-6);
});

test("the named conventions of G32 among the 16 rows", () => {
  const { rows, sameAs, paired } = atlas({
    quaternion: a,
    convention: HAMILTON,
    matrix: { function: "passive", direction: "world-to-body" },
  });
  const wanted = outputOf("G32");
  const placeOf = (convention) =>
    rows.findIndex((row) => JSON.stringify(row.convention) === JSON.stringify(convention));
  close(rows[placeOf(HAMILTON)].quaternion.array, wanted.hamilton_B2W_wxyz);
  close(rows[placeOf(HAMILTON_SCALAR_LAST)].quaternion.array, wanted.eigen_ros_B2W_xyzw);
  close(rows[placeOf(JPL)].quaternion.array, wanted.jpl_W2B_xyzw);
  close(rows[placeOf(quatlas.JPL_BODY_TO_WORLD)].quaternion.array, wanted.jpl_B2W_xyzw);
  close(rows[placeOf(quatlas.MY_LAB)].quaternion.array, wanted.mylab_active_W2B_wxyz);
  close(paired.rows, wanted.mylab_matrix_R_WtoB);
  assert.equal(rows.length, 16);
  assert.equal(sameAs[placeOf(JPL)], placeOf(HAMILTON_SCALAR_LAST));
});

test("all eight product matrices of the field guide", () => {
  const path = `${root}/tests/cases/product_matrices.json`;
  const quaternion = { w: 1, x: 2, y: 3, z: 4 };
  const numbersIn = (letters) =>
    letters
      .split(/ +/)
      .map((letter) => quaternion[letter.replace("-", "")] * (letter.startsWith("-") ? -1 : 1));
  for (const { handedness, order, left, right } of JSON.parse(readFileSync(path, "utf8"))) {
    const convention = { ...HAMILTON, handedness, order };
    const { declared } = read({ quaternion: "w=1 x=2 y=3 z=4", vector: "1 0 0", convention });
    assert.deepEqual(declared.leftProductMatrix.flat(), numbersIn(left));
    assert.deepEqual(declared.rightProductMatrix.flat(), numbersIn(right));
  }
});

test("the heading and the tilt", () => {
  const request = { quaternion: "yaw 65 pitch 20 roll -35 deg", axis: "z", convention: HAMILTON };
  const { twistDeg, swing } = swingTwist(request);
  close([twistDeg, swing.angleDeg], [71.3642, 39.6685], 1e-4);
  const { problems } = swingTwist({ ...request, axis: "0 0 0" });
  assert.deepEqual([problems[0].field, problems[0].code], ["axis", "zero-axis"]);
});

test("a problem of a factor tells its place, and a text that is too long its own length", () => {
  const factors = [{ text: "1 0 0 0" }, { text: "🙂 x" }, { text: "1 ".repeat(100_000) }];
  const { status, problems } = chain({ factors, convention: JPL });
  assert.equal(status, "problems");
  assert.deepEqual(
    problems.map(({ field, at, span }) => [field, at, span]),
    [
      ["factor", 1, { start: 0, end: 2 }],
      ["factor", 2, { start: 0, end: 200_000 }],
    ],
  );
  const many = (count) => ({ factors: Array(count).fill({ text: a }), convention: JPL });
  assert.equal(chain(many(32)).factors.length, 32);
  for (const count of [0, 33]) {
    assert.throws(() => chain(many(count)), {
      name: "TypeError",
      message: /`factors` needs 1 to 32 elements$/,
    });
  }
  assert.throws(() => chain({ factors: [{ text: a, inverse: 1 }], convention: JPL }), {
    message: /`factors\[0\]\.inverse` is a number, not true or false$/,
  });
});

test("read and compose answer what analyze does", () => {
  const asked = { quaternion: "0 0 √½ √½", vector: "1 0 0", convention: JPL };
  assert.deepEqual(read(asked), quatlas.analyze({ view: "read", ...asked }));
  const two = { p: "i", q: "j", vector: "1 0 0", convention: HAMILTON };
  assert.deepEqual(compose(two), quatlas.analyze({ view: "compose", ...two }));
  assert.throws(() => between({ ...two, view: "compose" }), { message: /between was asked$/ });
});
