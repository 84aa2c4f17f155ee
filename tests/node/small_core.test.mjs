// The core that the page begins with reads what most people type, and never reads it otherwise than the whole
// core does: what it cannot read has a problem there, and then the page asks the whole.
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { isDeepStrictEqual } from "node:util";
import * as whole from "../../pkg/quatlas.js";
import * as small from "../../pkg/small/quatlas_small.js";

const root = join(dirname(fileURLToPath(import.meta.url)), "..", "..");
const read = (path) => readFileSync(join(root, path), "utf8");
const smallBytes = readFileSync(join(root, "pkg/small/quatlas_small_bg.wasm"));
whole.initSync({ module: readFileSync(join(root, "pkg/quatlas_bg.wasm")) });
small.initSync({ module: smallBytes });

const { hamilton, jpl, hamiltonScalarLast } = whole.presets();
const conventions = [hamilton, hamiltonScalarLast, jpl, { ...jpl, order: "wxyz" }];

const reading = { view: "read", quaternion: "1 0 0 0", vector: "1 2 3", convention: hamilton };
const composing = { view: "compose", p: "1 0 0 0", q: "0 0 0 1", vector: "1 2 3", convention: jpl };

/** The requests in which a text is asked: in each field, and as an attitude in both kinds and orders. */
const requestsOf = (text) => [
  ...conventions.map((convention) => ({ ...reading, quaternion: text, convention })),
  { ...reading, vector: text },
  { ...composing, p: text },
  { ...composing, q: text },
];

function* filesOf(folder, ending) {
  for (const file of readdirSync(join(root, folder), { recursive: true })) {
    if (file.endsWith(ending)) yield join(folder, file);
  }
}

/** What stands in quotes, or in backticks on one line, and holds a digit. */
function* quotedIn(path) {
  for (const [, double, backtick] of read(path).matchAll(/"((?:[^"\\]|\\[\s\S])*)"|`([^`\n]+)`/g)) {
    const unescaped = (double ?? backtick)
      .replace(/\\\n\s*/g, "")
      .replace(/\\u\{?([0-9a-fA-F]+)\}?/g, (_, digits) =>
        String.fromCodePoint(Number.parseInt(digits, 16)),
      )
      .replace(/\\(.)/g, (_, mark) => ({ n: "\n", t: "\t" })[mark] ?? mark);
    if (/\d/.test(unescaped)) yield unescaped;
  }
}

function* stringsOf(value) {
  if (typeof value === "string" && /\d/.test(value)) yield value;
  else if (value && typeof value === "object") {
    for (const member of Object.values(value)) yield* stringsOf(member);
  }
}

/** The texts of the tests, of the examples and of the documents. */
function texts() {
  const found = new Set(whole.standardProbes().flatMap((probe) => [...stringsOf(probe)]));
  const add = (text) => text.length < 2000 && found.add(text);
  for (const path of filesOf("tests/text", ".rs")) for (const text of quotedIn(path)) add(text);
  for (const path of filesOf("tests/text/problems", ".txt")) add(read(path).split("\n---\n")[0]);
  const others = ["src/text/mod.rs", "README.md"];
  for (const folder of ["www/words/examples", "www/model/examples"]) {
    others.push(...filesOf(folder, ".ts"));
  }
  for (const path of others) for (const text of quotedIn(path)) add(text);
  for (const name of ["vectors/copied", "vectors/addresses", "cases/printed", "cases/lookalikes"]) {
    for (const text of stringsOf(JSON.parse(read(`tests/${name}.json`)))) add(text);
  }
  return found;
}

test("the small core answers as the whole core does, or says that there is a problem", () => {
  const counts = { same: 0, asksWhole: 0, problems: 0 };
  for (const text of texts()) {
    for (const request of requestsOf(text)) {
      const [mine, theirs] = [small, whole].map((core) => core.analyze(request));
      if (mine.status !== "problems") {
        // The difference is only written where there is one, which takes a while.
        if (!isDeepStrictEqual(mine, theirs)) assert.deepEqual(mine, theirs, text);
        counts.same += 1;
      } else if (theirs.status !== "problems") {
        counts.asksWhole += 1;
      } else {
        for (const { message, expected, hint, suggestion, choices, span } of mine.problems) {
          const none = ["", "", "", undefined, []];
          assert.deepEqual([message, expected, hint, suggestion, choices], none, text);
          assert.ok(span.start <= span.end && span.end <= text.length, text);
        }
        counts.problems += 1;
      }
    }
  }
  // That the texts were found.
  assert.ok(counts.same > 4000 && counts.asksWhole > 700 && counts.problems > 6000, counts);
});

/** What most people type; every form in more than one way. */
const oftenTyped = `
  1 0 0 0 | 0.92, 0, 0, 0.38 | [0, 0, 0.38, 0.92] | (0.92 0 0 0.38) | {0.92, 0, 0, 0.38} | 0.92; 0; 0; 0.38
  1/sqrt(2) 0 0 1/√2 | √½ 0 0 -√½ | cos(pi/8), 0, 0, sin(pi/8) | 1e-3 0.5f 2*.3 1-1/4 | −0.5 ½ 0 √½
  w=0.92 x=0 y=0 z=0.38 | (w: 0.92, x: 0, y: 0, z: 0.38) | {"x": 0, "y": 0, "z": 0.38, "w": 0.92}
  qw: 0.92 qx: 0 qy: 0 qz: 0.38 | q = [0.92, 0, 0, 0.38] | double q[4] = {0.92, 0, 0, 0.38};
  orientation: {x: 0.0, y: 0.0, z: 0.38, w: 0.92} | order: xyzw, 0 0 0.38 0.92 | quaternion 1 2 3 4
  0.92 + 0.38k | 1/√2 + 1/√2 i | 0.5 - 0.5i + 0.5j - 0.5k | √2/2 k + √2/2 | cos(22.5°) + sin(22.5°) k | 0.92 [0, 0, 0.38]
  45deg about z | 45° about [1, 1, 0] | rotate by 30 deg about the x axis | 45deg [0, 0, 1] | axis=z, angle=45°
  axis-angle [0, 0, 1] pi/4 | axis: [0, 0, 1] angle: 0.5 | angle-axis 0.785 0 0 1
  rotvec 0 0 0.785 | rotvec [0 0 45] deg | rotation vector: 0.1 0.2 0.3 | rvec = [0.1, 0.2, 0.3]
  gibbs 0 0 0.414 | mrp 0 0 0.199 | half-angle vector 0 0 22.5deg
  ZYX 30 20 10 | ZYX 30° 20° 10° | xyz 0.1 0.2 0.3 | 3-2-1 30 20 10 | intrinsic zyx 30 20 10 deg | sxyz 0.1 0.2 0.3
  rpy 0.1 0.2 0.3 | ypr: 30 20 10 | rpy="0.1 0.2 0.3" | roll=10deg pitch=20deg yaw=30deg | euler_zyx: 30 20 10
  roll: 0.1, pitch: 0.2, yaw: 0.3 | {"roll": 10, "pitch": 20, "yaw": 30, "unit": "deg"}
  [[0, -1, 0], [1, 0, 0], [0, 0, 1]] | [0 -1 0; 1 0 0; 0 0 1] | 0 -1 0 1 0 0 0 0 1 | 0, -1, 0, 1, 0, 0, 0, 0, 1
  R = [[0, -1, 0], [1, 0, 0], [0, 0, 1]] | R << 0, -1, 0, 1, 0, 0, 0, 0, 1; | matrix 0 -1 0 1 0 0 0 0 1`;

test("the small core reads by itself what most people type", () => {
  const typed = oftenTyped.split(/[|\n]/).filter((text) => text.trim() !== "");
  const lines = [
    "x: 0.0\ny: 0.0\nz: 0.38\nw: 0.92",
    "0 -1 0\n1 0 0\n0 0 1",
    "- 0.5\n- 0.5\n- 0.5\n- 0.5",
  ];
  for (const text of [...typed, ...lines]) {
    const request = { ...reading, quaternion: text, convention: jpl };
    const answer = small.analyze(request);
    assert.equal(answer.status, "read", text);
    assert.deepEqual(answer, whole.analyze(request), text);
  }
});

test("what the small core leaves to the whole one has a problem there, and a place", () => {
  const left = [
    "Eigen::Quaterniond(0.92, 0, 0, 0.38)",
    "Rotation.from_euler('ZYX', [30, 20, 10], degrees=True)",
    "Float32Array(4) [ 0.1, -0.2, 0.38, 0.92 ]",
    "x: 0 1 0, y: -1 0 0, z: 0 0 1",
    "0 0 1 1.5708",
  ];
  for (const quaternion of left) {
    const request = { ...reading, quaternion };
    assert.equal(whole.analyze(request).status, "read", quaternion);
    const { status, problems } = small.analyze(request);
    assert.equal(status, "problems", quaternion);
    assert.deepEqual([problems.length, problems[0].field], [1, "quaternion"], quaternion);
    assert.ok(problems[0].span.end > problems[0].span.start, quaternion);
  }
});

test("the small core has none of the sentences of problems", () => {
  const sentences = ["division by zero", "write the number you mean", "may be a difference"];
  const wholeBytes = readFileSync(join(root, "pkg/quatlas_bg.wasm"));
  for (const sentence of sentences) {
    assert.ok(wholeBytes.includes(sentence), sentence);
    assert.ok(!smallBytes.includes(sentence), sentence);
  }
});
