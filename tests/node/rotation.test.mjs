// Rotations of numbers through the built package: signs and orders by cases from outside, the laws of the
// group, and the bits of the core.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { test } from "node:test";
import { near, numbersFrom, refuses } from "./numbers.mjs";

const require = createRequire(import.meta.url);
const quatlas = require("../../dist/npm/quatlas.js");
const alone = require("../../dist/npm/quatlas_rotation.js");
const { HAMILTON, JPL, JPL_BODY_TO_WORLD, MY_LAB, Pose, Rotation, TaggedQuaternion } = quatlas;
const vectors = (name) =>
  JSON.parse(readFileSync(new URL(`../vectors/${name}.json`, import.meta.url), "utf8"));

test("the golden attitude of three different angles, in all eight conventions", () => {
  const { cases } = vectors("golden");
  const chosen = cases.filter(({ kind }) => kind === "convention");
  assert.equal(chosen.length, 8);
  for (const { convention: of, input, output, tol } of chosen) {
    const convention = {
      order: "scalar-first",
      handedness: of.handedness.toLowerCase(),
      function: of.function.toLowerCase(),
      direction: of.direction === "B2W" ? "body-to-world" : "world-to-body",
      perturbation: "local",
    };
    const body = Rotation.fromQuat(output.q_WB_wxyz, convention);
    const operator = of.tau === 1 ? "body-to-world" : "world-to-body";
    near(body.asMatrix(operator).flat(), output.S.flat(), tol);
    const image = of.tau === 1 ? body.apply(input.x) : body.applyInverse(input.x);
    near(image, output.S_x, tol * Math.max(1, ...input.x.map(Math.abs)));
    near(body.asQuat(convention), output.q_WB_wxyz, tol);
  }
});

test("SciPy's words give SciPy's numbers", () => {
  // scipy.spatial.transform.Rotation 1.17.1, of from_euler("ZYX", [30, 20, 10], degrees=True).
  const body = Rotation.fromEuler("ZYX", [30, 20, 10], "deg");
  const quat = [0.9515485246437885, 0.03813457647485015, 0.189307857412, 0.2392983377447303];
  near(body.asQuat(HAMILTON), quat, 3e-16);
  near(
    body.asEuler("zxz", "deg").angles,
    [-64.49444973901744, 22.268744495296882, 92.72683044319635],
    3e-14,
  );
  near(
    body.asEuler("XYZ", "deg").angles,
    [-1.1160546770046367, 22.242180910309518, 28.451775256585496],
    3e-14,
  );
  near(body.apply([1, 2, 3]), [1.067425379398986, 2.289059482620617, 2.760581414202371], 2e-15);
  near(
    body.applyInverse([1, 2, 3]),
    [0.7274298721582759, 1.813686361488493, 3.190828664037357],
    2e-15,
  );
  near(body.asRotvec(), [0.0775253166151003, 0.38485156884515354, 0.4864792299807579]);
  near(body.asMrp(), [0.0195406755165418, 0.09700392023127066, 0.12261972209397605]);
  near([body.magnitude()], [0.62512634399897]);
  const half = [-0.03876265830755015, -0.19242578442257677, -0.24323961499037894];
  near(body.pow(-0.5).asRotvec(), half);
});

test("what a convention means is not what its numbers are", () => {
  const numbers = [0.1, -0.3, 0.5, 0.7];
  const norm = Math.hypot(...numbers);
  // C(q) of JPL's numbers is the transpose of R(q) of the same; world to body, it is no other attitude.
  const jpl = Rotation.fromQuat(numbers, JPL);
  const hamilton = Rotation.fromQuat([0.7, 0.1, -0.3, 0.5], HAMILTON);
  assert.deepEqual(jpl.asMatrix("body-to-world"), hamilton.asMatrix("body-to-world"));
  const reversed = Rotation.fromQuat(numbers, JPL_BODY_TO_WORLD);
  assert.deepEqual(reversed.asMatrix("body-to-world"), jpl.asMatrix("world-to-body"));
  near(
    jpl.asQuat(JPL),
    numbers.map((number) => number / norm),
  );
  // My Lab is active from world to body: R_WB acts, as Hamilton's does.
  assert.deepEqual(
    Rotation.fromQuat([0.7, 0.1, -0.3, 0.5], MY_LAB).asQuat(HAMILTON),
    hamilton.asQuat(HAMILTON),
  );
});

test("one library of each family, by its id", () => {
  const numbers = { first: [0.7, 0.1, -0.3, 0.5], last: [0.1, -0.3, 0.5, 0.7] };
  const hamilton = Rotation.fromQuat(numbers.first, HAMILTON);
  for (const id of [
    "eigen",
    "openvins",
    "gtsam",
    "drake",
    "scipy-scalar-first",
    "directxmath",
    "basilisk",
  ]) {
    const { to } = quatlas.translate({
      quaternion: numbers.first,
      from: { kind: "convention", convention: HAMILTON },
      to: { kind: "library", id },
    });
    const read = Rotation.fromQuat(to.array, id);
    assert.ok(read.angleTo(hamilton) < 4e-16, `${id}: ${read} and ${hamilton}`);
  }
  refuses("unknown-library", () => Rotation.fromQuat(numbers.first, "no-such-library"));
  refuses("unknown-convention", () => alone.Rotation.fromQuat(numbers.first, "eigen"));
});

test("the laws of the group, and every description comes back", () => {
  const next = numbersFrom(7);
  const sequences = ["ZYX", "xyz", "ZXZ", "yxy"];
  for (let times = 0; times < 300; times += 1) {
    const [a, b, c] = [0, 0, 0].map(() => Rotation.fromQuat([next(), next(), next(), next()], JPL));
    const vector = [next(), next(), next()];
    assert.ok(
      a
        .andThen(b)
        .andThen(c)
        .angleTo(a.andThen(b.andThen(c))) < 1e-15,
    );
    assert.ok(a.andThen(b).inv().angleTo(b.inv().andThen(a.inv())) < 1e-15);
    near(a.andThen(b).apply(vector), a.apply(b.apply(vector)), 2e-15);
    near(a.applyInverse(a.apply(vector)), vector, 2e-15);
    for (const direction of ["body-to-world", "world-to-body"]) {
      assert.ok(Rotation.fromMatrix(a.asMatrix(direction), direction).angleTo(a) < 1e-15);
    }
    for (const sequence of sequences) {
      for (const unit of ["rad", "deg"]) {
        const { angles } = a.asEuler(sequence, unit);
        assert.ok(Rotation.fromEuler(sequence, angles, unit).angleTo(a) < 4e-15);
      }
    }
    const { axis, angle } = a.asAxisAngle("deg");
    assert.ok(Rotation.fromAxisAngle(axis, angle, "deg").angleTo(a) < 3e-15);
    assert.ok(Rotation.fromRotvec(a.asRotvec()).angleTo(a) < 2e-15);
    assert.ok(Rotation.fromMrp(a.asMrp()).angleTo(a) < 2e-15);
    assert.ok(a.slerp(b, 0.25).angleTo(a.andThen(a.inv().andThen(b).pow(0.25))) < 4e-15);
    for (const axes of ["local", "global"]) {
      assert.ok(a.plus(b.minus(a, axes), axes).angleTo(b) < 4e-15);
    }
    for (const axes of ["body", "world"]) {
      const rate = a.rateTo(b, 0.1, axes);
      assert.ok(a.integrate(rate, 0.1, axes).angleTo(b) < 4e-15);
      assert.ok(a.integrate(() => rate, 0.1, axes).angleTo(b) < 4e-15);
    }
  }
});

test("a rate that changes is integrated to fourth order, on either axes", () => {
  // About a fixed axis the angle is the integral: of t³ from 0 to 2 that is 4.
  const turn = Rotation.identity().integrate((t) => [0, 0, t ** 3], 2, "body");
  assert.ok(
    Math.abs(turn.asRotvec()[2] - (4 - 2 * Math.PI)) < 1e-14 ||
      Math.abs(turn.magnitude() - (2 * Math.PI - 4)) < 1e-14,
  );
  // Halving the step takes a sixteenth of the error, where the axis moves.
  const rate = (t) => [Math.cos(3 * t), Math.sin(2 * t), t];
  const after = (steps) => {
    let body = Rotation.identity();
    for (let at = 0; at < steps; at += 1) {
      body = body.integrate((t) => rate(at / steps + t), 1 / steps, "body");
    }
    return body;
  };
  const exact = after(512);
  const ratio = after(8).angleTo(exact) / after(16).angleTo(exact);
  assert.ok(ratio > 13 && ratio < 20, String(ratio));
});

test("products of tagged quaternions keep to their algebra, and do not mix", () => {
  const [i, j] = [
    [0, 1, 0, 0],
    [0, 0, 1, 0],
  ];
  const hamilton = TaggedQuaternion.of(i, HAMILTON).times(TaggedQuaternion.of(j, HAMILTON));
  assert.deepEqual(hamilton.array, [0, 0, 0, 1]);
  const shuster = { ...HAMILTON, handedness: "left" };
  const left = TaggedQuaternion.of(i, shuster).times(TaggedQuaternion.of(j, shuster));
  assert.deepEqual(left.array, [0, 0, 0, -1]);
  refuses("mixed-conventions", () =>
    TaggedQuaternion.of(i, HAMILTON).times(TaggedQuaternion.of(j, JPL)),
  );
  refuses("mixed-conventions", () =>
    TaggedQuaternion.of(i, HAMILTON).minus(TaggedQuaternion.of(j, shuster), "physical"),
  );
  // A product of attitudes is one of quaternions, in the order that the convention has.
  const [p, q] = [
    [0.1, -0.3, 0.5, 0.7],
    [0.4, 0.2, -0.6, 0.3],
  ];
  const whole = Rotation.fromQuat(p, JPL).andThen(Rotation.fromQuat(q, JPL));
  const tagged = TaggedQuaternion.of(q, JPL).times(TaggedQuaternion.of(p, JPL));
  assert.ok(Rotation.fromQuat(tagged).angleTo(whole) < 1e-15);
});

test("plus and minus of tagged quaternions have the side and the sign of the convention", () => {
  const { cases } = vectors("golden");
  assert.ok(cases.length > 20);
  const next = numbersFrom(11);
  const handed = ["right", "left"];
  for (const handedness of handed) {
    for (const direction of ["body-to-world", "world-to-body"]) {
      for (const perturbation of ["local", "global"]) {
        const convention = { ...HAMILTON, handedness, direction, perturbation };
        const array = [next(), next(), next(), next()];
        const body = TaggedQuaternion.of(array, convention).normalize();
        const turn = [next() / 9, next() / 9, next() / 9];
        const turned = body.plus(turn, "physical");
        const expected = Rotation.fromQuat(body).plus(turn, perturbation);
        assert.ok(Rotation.fromQuat(turned).angleTo(expected) < 1e-15);
        near(turned.minus(body, "physical"), turn, 4e-16);
        near(body.plus(turn, "formal").minus(body, "formal"), turn, 4e-16);
        // The derivative is what plus does in a small time.
        const axes = perturbation === "local" ? "body" : "world";
        const step = 1e-6;
        const later = body.plus(
          turn.map((rate) => rate * step),
          "physical",
        ).array;
        const earlier = body.plus(
          turn.map((rate) => -rate * step),
          "physical",
        ).array;
        const derivative = later.map((number, at) => (number - earlier[at]) / (2 * step));
        near(body.derivative(turn, axes), derivative, 1e-9);
        const omega = quatlas.rateMatrix(turn, convention, axes);
        near(
          body.derivative(turn, axes),
          omega.map((row) => row.reduce((sum, entry, at) => sum + entry * body.array[at], 0) / 2),
        );
      }
    }
  }
});

test("poses go along frames that meet", () => {
  const turn = (axis, angle) => Rotation.fromAxisAngle(axis, angle, "deg");
  const body = Pose.of({
    rotation: turn([0, 0, 1], 90),
    position: [5, 0, 0],
    parent: "G",
    child: "I",
  });
  const camera = Pose.of({
    rotation: turn([0, 1, 0], 90),
    position: [1, 2, 3],
    parent: "I",
    child: "C",
  });
  const seen = body.andThen(camera);
  near(seen.position, [3, 1, 3]);
  assert.deepEqual([seen.parent, seen.child], ["G", "C"]);
  // The same by the text.
  const { answer } = quatlas.frames({
    poses: [
      { parent: "G", child: "I", rotation: "90° about z", position: [5, 0, 0] },
      { parent: "I", child: "C", rotation: "90° about y", position: [1, 2, 3] },
    ],
    child: "C",
    parent: "G",
    convention: HAMILTON,
  });
  assert.deepEqual(seen.position, answer.position);
  assert.deepEqual(seen.rotation.asMatrix("body-to-world"), answer.hamilton.matrix);
  near(seen.inv().apply(seen.position), [0, 0, 0]);
  refuses("frames-do-not-meet", () => camera.andThen(body));
  for (const direction of ["body-to-world", "world-to-body"]) {
    const again = Pose.fromMatrix(seen.asMatrix(direction), direction);
    near(again.position, seen.position, 4e-15);
    assert.ok(again.rotation.angleTo(seen.rotation) < 1e-15);
  }
  refuses("not-a-rotation", () =>
    Pose.fromMatrix(
      [
        [1, 0, 0, 0],
        [0, 1, 0, 0],
        [0, 0, 1, 0],
        [5, 0, 0, 1],
      ],
      "body-to-world",
    ),
  );
});

test("the numbers have the bits of the core", () => {
  // The core, asked by texts, answers for the same inputs.
  const next = numbersFrom(5);
  for (let times = 0; times < 200; times += 1) {
    const size = 10 ** (next() * 150);
    const array = [next(), next(), next(), next()].map((number) => number * size);
    const vector = [next(), next(), next()];
    const convention = next() > 0 ? JPL : HAMILTON;
    const report = quatlas.read({ quaternion: array, vector, convention });
    if (report.status !== "read") continue;
    const body = Rotation.fromQuat(array, convention);
    assert.deepEqual(body.asQuat(HAMILTON), report.hamilton.unit.array);
    assert.deepEqual(body.asQuat(JPL), report.jpl.unit.array);
    assert.deepEqual(body.asMatrix("body-to-world"), report.hamilton.matrix);
    assert.deepEqual(body.apply(vector), report.hamilton.image);
    assert.deepEqual(body.applyInverse(vector), report.jpl.image);
    assert.deepEqual(body.asEuler("ZYX", "deg").angles, report.euler.anglesDeg);
  }
});

test("all reference cases have the bits of a native build", () => {
  const { operations } = vectors("accuracy");
  const rotation = (input, from = 0) => Rotation.fromQuat(input.slice(from, from + 4), HAMILTON);
  const tagged = (input, from = 0) => TaggedQuaternion.of(input.slice(from, from + 4), HAMILTON);
  const ofMatrix = (input) => {
    const rows = [0, 3, 6].map((at) => input.slice(at, at + 3));
    return Rotation.nearestToMatrix(rows, "body-to-world").rotation;
  };
  const euler = (input, sequence) => rotation(input).asEuler(sequence, "rad").angles;
  // In the order of tests/support/measured/operations.rs.
  const run = [
    ["normalize", (input) => tagged(input).normalize().array],
    ["matrix", (input) => rotation(input).asMatrix("body-to-world").flat()],
    ["product", (input) => tagged(input).times(tagged(input, 4)).array],
    ["rotate", (input) => rotation(input).apply(input.slice(4, 7))],
    ["quaternion_from_matrix", (input) => ofMatrix(input).asQuat(HAMILTON)],
    ["rotation_vector_from_quaternion", (input) => rotation(input).asRotvec()],
    ["rotation_vector_from_matrix", (input) => ofMatrix(input).asRotvec()],
    ["quaternion_from_rotation_vector", (input) => Rotation.fromRotvec(input).asQuat(HAMILTON)],
    [
      "quaternion_from_euler",
      (input, sequence) => Rotation.fromEuler(sequence, input, "rad").asQuat(HAMILTON),
    ],
    ["euler_from_quaternion", euler],
    ["euler_from_quaternion", euler],
    ["slerp", (input) => rotation(input).slerp(rotation(input, 4), input[8]).asQuat(HAMILTON)],
    ["angle_between", (input) => [rotation(input).angleTo(rotation(input, 4))]],
  ];
  // FNV-1a, 64 bits, as in tests/rotation/accuracy.rs, where the same number stands.
  let hash = 0xcbf29ce484222325n;
  for (const [name, operation] of run) {
    for (const { input, sequence: letters = "", frame } of operations[name]) {
      const sequence = { axes: letters.toLowerCase(), frame };
      for (const byte of new Uint8Array(Float64Array.from(operation(input, sequence)).buffer)) {
        hash = BigInt.asUintN(64, (hash ^ BigInt(byte)) * 0x100000001b3n);
      }
    }
  }
  const native = readFileSync(new URL("../rotation/accuracy.rs", import.meta.url), "utf8");
  assert.ok(native.includes(hash.toString().replace(/\B(?=(\d{3})+$)/g, "_")), `${hash}`);
});
