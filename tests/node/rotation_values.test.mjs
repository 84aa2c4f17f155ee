// Rotations as values of JavaScript: their shape, what is refused, memory, and threads.
import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { test } from "node:test";
import { Worker } from "node:worker_threads";
import { refuses } from "./numbers.mjs";

const require = createRequire(import.meta.url);
const quatlas = require("../../dist/npm/quatlas.js");
const alone = require("../../dist/npm/quatlas_rotation.js");
const { HAMILTON, JPL, Pose, Rotation, TaggedQuaternion } = quatlas;

test("a rotation of another entry is told by its shape", () => {
  const [one, other] = [quatlas, alone].map(({ Rotation: of }) =>
    of.fromRotvec([0.1, -0.2, 5e-324]),
  );
  assert.ok(!(other instanceof Rotation));
  assert.equal(one.angleTo(other), 0);
  assert.deepEqual(Rotation.from(other).asRotvec(), one.asRotvec());
  assert.deepEqual(one.andThen(other).asQuat(JPL), other.andThen(one).asQuat(JPL));
  refuses("wrong-type", () => one.andThen({ w: 1, x: 0, y: 0, z: 0 }));
});

test("a rotation is a frozen value that can be awaited, compared and told", async () => {
  const body = Rotation.fromQuat([0, 0, 0.6, 0.8], JPL);
  assert.equal(await body, body);
  assert.equal("then" in body, false);
  assert.ok(Object.isFrozen(body));
  assert.deepEqual(JSON.parse(JSON.stringify(body)), { w: 0.8, x: 0, y: 0, z: 0.6 });
  assert.notDeepEqual(body, body.inv());
  const { hamilton } = quatlas.read({ quaternion: String(body), vector: "1 0 0", convention: JPL });
  assert.deepEqual(hamilton.unit.array, body.asQuat(HAMILTON));
  refuses("wrong-type", () => new Rotation());
  assert.deepEqual(
    [Rotation, TaggedQuaternion, Pose].map(({ name }) => name),
    ["Rotation", "TaggedQuaternion", "Pose"],
  );
});

test("what cannot be computed with is refused with a code and a hint", () => {
  const gone = new Float64Array(4);
  structuredClone(gone, { transfer: [gone.buffer] });
  const body = Rotation.identity();
  const mirror = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, -1],
  ];
  const cases = [
    ["wrong-count", () => Rotation.fromQuat(gone, JPL)],
    ["wrong-count", () => Rotation.fromQuat([0, 0, 1], JPL)],
    ["wrong-type", () => Rotation.fromQuat("0 0 0 1", JPL)],
    ["wrong-type", () => Rotation.fromQuat([0, 0, "0", 1], JPL)],
    ["wrong-type", () => Rotation.fromQuat(undefined, JPL)],
    ["not-finite", () => Rotation.fromQuat([0, 0, Number.NaN, 1], JPL)],
    ["not-finite", () => Rotation.fromQuat([0, 0, Infinity, 1], JPL)],
    ["zero-quaternion", () => Rotation.fromQuat([0, 0, 0, -0], JPL)],
    ["unknown-convention", () => Rotation.fromQuat([0, 0, 0, 1])],
    ["unknown-convention", () => Rotation.fromQuat([0, 0, 0, 1], {})],
    ["unknown-convention", () => Rotation.fromQuat([0, 0, 0, 1], { ...JPL, order: "wxyz" })],
    ["wrong-count", () => Rotation.fromMatrix([1, 0, 0, 0, 1, 0, 0, 0, 1], "body-to-world")],
    ["reflection", () => Rotation.fromMatrix(mirror, "body-to-world")],
    [
      "not-a-rotation",
      () =>
        Rotation.fromMatrix(
          [
            [2, 0, 0],
            [0, 1, 0],
            [0, 0, 1],
          ],
          "body-to-world",
        ),
    ],
    [
      "not-unique",
      () =>
        Rotation.nearestToMatrix(
          [
            [0, 0, 0],
            [0, 0, 0],
            [0, 0, 0],
          ],
          "body-to-world",
        ),
    ],
    ["unknown-choice", () => Rotation.fromMatrix(mirror)],
    ["unknown-choice", () => Rotation.fromEuler("ZYX", [1, 2, 3])],
    ["unknown-sequence", () => Rotation.fromEuler("ZZX", [1, 2, 3], "deg")],
    ["unknown-sequence", () => Rotation.fromEuler("ZyX", [1, 2, 3], "deg")],
    ["zero-vector", () => Rotation.fromAxisAngle([0, 0, 0], 1, "rad")],
    ["zero-vector", () => Rotation.fromTwoVectors([1, 0, 0], [0, 0, 0])],
    ["wrong-type", () => Rotation.random()],
    ["too-large", () => Rotation.fromAxisAngle([1, 0, 0], 180, "deg").asGibbs()],
    ["too-large", () => Rotation.fromAxisAngle([0, 0, 1], 45, "deg").apply([1.7e308, 1.7e308, 0])],
    ["too-large", () => body.rateTo(Rotation.fromRotvec([1, 2, 3]), 0, "body")],
    ["wrong-type", () => body.andThen(undefined)],
    ["unknown-choice", () => body.plus([0, 0, 1], "body")],
    ["not-finite", () => body.slerp(body, Number.NaN)],
  ];
  for (const [code, call] of cases) refuses(code, call);
});

test("where the stack of JavaScript is full, the numbers after it are right", () => {
  const rows = Rotation.fromEuler("ZYX", [30, 20, 10], "deg").asMatrix("body-to-world");
  const expected = Rotation.fromMatrix(rows, "body-to-world").asQuat(JPL);
  let stopped = 0;
  for (let times = 0; times < 400; times += 1) {
    const deeper = () => {
      try {
        deeper();
      } catch {}
      try {
        Rotation.fromMatrix(rows, "body-to-world");
      } catch {
        stopped += 1;
      }
    };
    if (times < 3) deeper();
    assert.deepEqual(Rotation.fromMatrix(rows, "body-to-world").asQuat(JPL), expected);
  }
  assert.ok(stopped > 0);
});

test("a million calls leave the memory of the core as it was", () => {
  const body = Rotation.fromEuler("ZYX", [1, 2, 3], "deg");
  let turned = body;
  for (let times = 0; times < 20_000; times += 1) turned = turned.andThen(body);
  const before = process.memoryUsage().arrayBuffers;
  for (let times = 0; times < 1_000_000; times += 1) turned = turned.andThen(body);
  const after = process.memoryUsage().arrayBuffers;
  assert.ok(after <= before, `${before} to ${after}`);
  assert.ok(Math.abs(Math.hypot(...turned.asQuat(JPL)) - 1) < 3e-16);
});

test("two worker threads at once have the same bits", async () => {
  const script = `
    const { parentPort } = require("node:worker_threads");
    const { Rotation, JPL } = require(${JSON.stringify(require.resolve("../../dist/npm/quatlas_rotation.js"))});
    const step = Rotation.fromEuler("ZYX", [1, 2, 3], "deg");
    let turned = step;
    for (let times = 0; times < 20000; times += 1) turned = turned.andThen(step);
    parentPort.postMessage(turned.asQuat(JPL));
  `;
  const told = [0, 1].map(
    () =>
      new Promise((resolve, reject) => {
        const worker = new Worker(script, { eval: true });
        worker.once("message", resolve);
        worker.once("error", reject);
      }),
  );
  const [one, other] = await Promise.all(told);
  assert.deepEqual(one, other);
});
