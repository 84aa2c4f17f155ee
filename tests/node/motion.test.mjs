// What the package answers of an attitude in motion, to the golden numbers.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { test } from "node:test";
import { fileURLToPath } from "node:url";

const root = fileURLToPath(new URL("../..", import.meta.url));
const quatlas = createRequire(import.meta.url)("../../dist/npm/quatlas.js");
const { HAMILTON, JPL, motion } = quatlas;
const golden = JSON.parse(readFileSync(`${root}/tests/vectors/golden.json`, "utf8")).cases;
const caseOf = (id) => golden.find((of) => of.id === id);
const outputOf = (id) => caseOf(id).output;

const attitude = "rotvec 0.4 -0.7 1.1";
const rate = [0.11, -0.23, 0.37];
const increment = [0.02, -0.03, 0.05];

function close(got, wanted, tolerance = 4e-15) {
  const numbers = [got].flat(2);
  const expected = [wanted].flat(2);
  assert.equal(numbers.length, expected.length);
  for (const [at, number] of numbers.entries()) {
    const off = Math.abs(number - expected[at]);
    assert.ok(off <= tolerance * Math.max(1, Math.abs(expected[at])), `${numbers} is ${expected}`);
  }
}

test("increments and derivatives of G01 to G08", () => {
  const names = { B2W: "body-to-world", W2B: "world-to-body" };
  for (const { id, convention, output } of golden.slice(0, 8)) {
    const declared = {
      ...HAMILTON,
      handedness: convention.handedness.toLowerCase(),
      function: convention.function.toLowerCase(),
      direction: names[convention.direction],
    };
    const report = motion({ quaternion: attitude, convention: declared, rate, increment });
    assert.equal(report.status, "motion", id);
    close(report.increment.plus[0].quaternion.array, output.q_plus_local);
    close(report.increment.plus[3].quaternion.array, output.q_plus_global);
    close(report.derivative.quaternions[0].quaternion.array, output.q_dot);
    close(report.derivative.worldRad, output.omega_W);
    // Physical increments have the sign of the convention, formal ones none.
    assert.equal(report.increment.plus[0].sign, convention.sigma);
    assert.equal(report.increment.plus[0].side, convention.tau > 0 ? "right" : "left");
  }
});

test("Euler rates of G24, the Jacobians of G26, Ω of G31 and the matrices of G33", () => {
  const locked = motion({
    quaternion: "ZYX 0.7 -0.4 1.1 rad",
    convention: HAMILTON,
    rate: outputOf("G24").omega_B,
  }).derivative;
  close(locked.eulerRatesRad, caseOf("G24").input.rates, 1e-14);
  const { derivative } = motion({ quaternion: attitude, convention: JPL, rate });
  close(derivative.rightJacobian, outputOf("G26").Jr);
  close(derivative.rightJacobianInverse, outputOf("G26").Jr_inv);
  close(derivative.vectorRateRad, outputOf("G26").v_dot);
  const { quaternions } = motion({
    quaternion: "0.8 0.2 0.4 0.4",
    convention: HAMILTON,
    rate: [1, 2, 3],
  }).derivative;
  const twice = (at) => quaternions[at].quaternion.array.map((number) => 2 * number);
  close(twice(1), outputOf("G31").OmegaH_q);
  close(twice(2), outputOf("G31").OmegaJ_q_xyzw);
  assert.deepEqual(quaternions[2].matrix[0], [0, 3, -2, 1]);
  for (const [perturbation, name] of [
    ["local", "R_WB_local"],
    ["global", "R_WB_global"],
  ]) {
    const convention = { ...HAMILTON, perturbation };
    const after = motion({ quaternion: attitude, convention, increment }).increment;
    close(after.bodyToWorld, outputOf("G33")[name]);
  }
});

test("a path, its mistakes and its integrators", () => {
  const asked = { quaternion: attitude, convention: JPL, rate, duration: "10 s", steps: 10 };
  const { path } = motion(asked);
  close(path.turn.rotationVectorRad, [-0.056082, 0.260684, -0.340053], 1e-6);
  close(
    path.mistakes.slice(0, 2).map(({ angleDeg }) => angleDeg),
    [5.787, 154.8975],
    1e-4,
  );
  assert.equal(path.ways.length, 1 + path.mistakes.length);
  assert.equal(path.integrators.length, 7);
  const long = { ...asked, rateEnd: [0.3, 0.1, -0.2], steps: 240, increment };
  assert.equal(motion(long).path.ways[0].length, 241);
});

test("G34: one step of fourth order is as far from the right end as it is told to be", () => {
  const [early, late] = [
    [0.3, -0.2, 0.5],
    [0.1, 0.4, -0.6],
  ];
  // Both rates stand at the Gauss points of a step, (½ ∓ √3/6) h.
  const at = (side) =>
    early.map((of, axis) => (of + late[axis]) / 2 + side * (late[axis] - of) * (Math.sqrt(3) / 2));
  const identity = { quaternion: [1, 0, 0, 0], convention: HAMILTON };
  const asked = { ...identity, rate: at(-1), rateEnd: at(1), duration: "100 ms", steps: 1 };
  const { ways, integrators } = motion(asked).path;
  const { q_step } = outputOf("G34");
  const cross = ways[0][1].slice(1).reduce((sum, number, of) => sum + number * q_step[of], 0);
  const apart = Math.hypot(...ways[0][1].slice(1).map((number, of) => number - q_step[of]));
  assert.ok(cross > 0.99);
  const [count, step, error] = integrators[2][0];
  assert.deepEqual([count, step], [1, 0.1]);
  assert.ok(apart > 1e-10 && Math.abs(error - 2 * apart) < 1e-14, `${error} and ${2 * apart}`);
});

test("what is typed is a problem with its place, what is not of the type is refused", () => {
  const { status, problems } = motion({
    quaternion: attitude,
    convention: HAMILTON,
    rate: "0.1 0.2 rad/s",
    duration: "0 s",
  });
  assert.equal(status, "problems");
  assert.deepEqual(
    problems.map(({ field, code }) => [field, code]),
    [
      ["rate", "wrong-count"],
      ["duration", "out-of-bounds"],
    ],
  );
  for (const steps of [0, 241, 1.5, Number.NaN, "4", null]) {
    assert.throws(() => motion({ quaternion: attitude, convention: HAMILTON, steps }), {
      name: "TypeError",
      message: /`steps` is/,
    });
  }
  assert.throws(() => motion({ quaternion: attitude, convention: HAMILTON, rateAxes: "sky" }), {
    message: /`rateAxes` cannot be `sky`, but one of `body`, `world`/,
  });
});
