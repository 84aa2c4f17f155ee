// Poses between named frames through the built package.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { test } from "node:test";

const quatlas = createRequire(import.meta.url)("../../dist/npm/quatlas.js");
const { frames, HAMILTON, JPL } = quatlas;

const golden = JSON.parse(readFileSync(new URL("../vectors/golden.json", import.meta.url), "utf8"));
const { input, output, tol } = golden.cases.find(({ id }) => id === "G29");

const transposed = (rows) => rows[0].map((_, at) => rows.map((row) => row[at]));
const turn = (vector) => `rotvec ${vector.join(" ")}`;

/** Figure 1 of Yoosefian 2021. */
const rig = () => [
  { parent: "G", child: "I1", rotation: turn(input.v_GI1), position: input.p_GI1 },
  { parent: "I1", child: "C1", rotation: turn(input.v_IC), position: input.p_IC },
  { parent: "I2", child: "C2", rotation: turn(input.v_IC), position: input.p_IC },
  {
    parent: "C1",
    child: "C2",
    rotation: transposed(output.R_C2_C1),
    position: output.p_C1_C2,
  },
];

const close = (got, wanted, what, tolerance = 4 * tol) => {
  for (const [at, number] of wanted.entries()) {
    assert.ok(Math.abs(got[at] - number) <= tolerance, `${what}: ${got} for ${wanted}`);
  }
};

test("G29: the second body over the cameras, as it is and as it is printed", () => {
  const { answer, path, problems } = frames({
    poses: rig(),
    child: "I2",
    parent: "G",
    convention: HAMILTON,
  });
  assert.deepEqual(problems, []);
  close(answer.position, output.p_GI2_corrected, "position");
  close(answer.turn.rotationVectorRad, input.v_GI2, "turn");
  close(answer.misprintedPosition, output.p_GI2_as_printed, "as printed");
  close([answer.misprintedDistance], [0.341631], "E10", 1e-6);
  assert.deepEqual(
    path.map(({ pose, inverted }) => [pose, inverted]),
    [
      [0, false],
      [1, false],
      [3, false],
      [2, true],
    ],
  );
});

test("problems count the units of their texts, and leave the other poses", () => {
  const poses = [
    ...rig(),
    { parent: "🙂", child: "𝔊", rotation: "1 0 0 zero", position: "" },
    { parent: "𝔊", child: "𝔊", rotation: "1 0 0 0" },
    { parent: "A", child: "B", rotation: "1".repeat(200_000) },
  ];
  const report = frames({ poses, child: "i1 ", parent: "G", convention: JPL });
  const [{ code, field, span, suggestion }] = report.problems;
  assert.deepEqual([code, field, span], ["unknown-frame", "child", { start: 0, end: 2 }]);
  assert.deepEqual([suggestion.remedy, suggestion.text], ["rename-frame", "I1"]);
  const problemOf = (at) => report.poses[at].problems[0];
  assert.deepEqual(problemOf(4).span, { start: 6, end: 10 });
  assert.deepEqual([problemOf(5).code, problemOf(5).span.end], ["same-frame", 2]);
  assert.equal(problemOf(6).code, "text-too-long");
  assert.match(problemOf(6).message, /200000 bytes; at most 4096/);
  assert.equal(report.poses[3].problems.length, 0);
});

test("32 poses are answered, and none is heard of behind the 33rd", () => {
  const pose = (at) => ({
    parent: `F${Math.floor(at / 2)}`,
    child: `F${at + 1}`,
    rotation: `rotvec 0.${at} -0.2 0.3`,
    position: [at, 1, 2],
  });
  const poses = Array.from({ length: 16 }, (_, at) => pose(at));
  // As many loops, none of which closes.
  for (let at = 0; at < 16; at += 1) poses.push({ ...pose(at), rotation: "1 0 0 0" });
  const request = { poses, child: "F15", parent: "F16", point: [1, 2, 3], convention: HAMILTON };
  assert.equal(frames(request).loops.length, 16);
  const more = frames({ ...request, poses: [...poses, pose(32), pose(33)] });
  assert.equal(more.poses.length, 33);
  assert.equal(more.poses[32].problems[0].code, "too-many-poses");
});
