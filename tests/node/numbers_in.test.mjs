// Numbers in place of texts: whoever has an array need not print it, and what cannot be numbers is refused.
import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { test } from "node:test";

const quatlas = createRequire(import.meta.url)("../../dist/npm/quatlas.js");
const { analyze, HAMILTON, identify, identifyNumbers, JPL, translate } = quatlas;

const read = (quaternion, convention = JPL, vector = [1, 2, 3]) =>
  analyze({ view: "read", quaternion, vector, convention });

/** The report, without the one thing in which a text and numbers may differ: where a note stands. */
const numbersOf = ({ notes, ...report }) => [report, notes.map(({ fact }) => fact)];

test("four numbers in any kind of array are the text of them", () => {
  const typed = numbersOf(read("[0.1, -0.2, 0.4, 0.8]", JPL, "1 2 3"));
  const numbers = [0.1, -0.2, 0.4, 0.8];
  for (const given of [numbers, Float64Array.from(numbers), Object.freeze([...numbers])]) {
    assert.deepEqual(numbersOf(read(given, JPL, Float32Array.of(1, 2, 3))), typed);
  }
  assert.deepEqual(read(numbers).jpl.quaternion.array, numbers);
  // A number of single precision is the double that it is.
  assert.equal(read(Float32Array.from(numbers)).jpl.quaternion.x, Math.fround(0.1));
});

test("rows are a matrix, and the direction is that which is declared", () => {
  const rows = [
    [0, -1, 0],
    [1, 0, 0],
    [0, 0, 1],
  ];
  for (const given of [rows, rows.map((row) => Float64Array.from(row)), rows.flat()]) {
    const { hamilton } = read(given, HAMILTON);
    assert.deepEqual(hamilton.matrix, rows);
    assert.ok(hamilton.unit.z > 0.7);
  }
});

test("numbers go into every other request", () => {
  const translated = translate({
    quaternion: Float64Array.of(0, 0, 0.6, 0.8),
    from: { kind: "library", id: "openvins" },
    to: { kind: "library", id: "scipy-scalar-first" },
  });
  assert.deepEqual(translated.to.array, [0.8, 0, 0, 0.6]);
  const observed = identify({
    observations: [{ probe: "product", a: [0, 1, 0, 0], b: [0, 0, 1, 0], printed: [0, 0, 0, -1] }],
  });
  assert.deepEqual(observed.remaining.handedness, ["left"]);
  const product = analyze({
    view: "compose",
    p: [Math.SQRT1_2, Math.SQRT1_2, 0, 0],
    q: [Math.SQRT1_2, 0, Math.SQRT1_2, 0],
    vector: [1, 0, 0],
    convention: HAMILTON,
  });
  assert.ok(product.declared.quaternion.z > 0.4);
  const told = identifyNumbers({
    numbers: [314.45, 301.32, 65.83],
    quaternion: "w=0.77781 x=-0.52878 y=-0.19588 z=0.27755",
    convention: HAMILTON,
  });
  assert.deepEqual(told.readings[0].meaning.sequence, { axes: "yxz", frame: "intrinsic" });
});

test("numbers that are no rotation are a problem with its place in the list that they are", () => {
  const codeOf = (given) => {
    const { status, problems } = read(given);
    assert.equal(status, "problems");
    return [problems[0].code, problems[0].span];
  };
  assert.deepEqual(codeOf([0, 0, 0, 0]), ["zero-quaternion", { start: 0, end: 12 }]);
  assert.deepEqual(codeOf([0.1, Number.NaN, 0, 1]), ["not-a-number", { start: 6, end: 9 }]);
  assert.deepEqual(codeOf([0.1, 0, Number.POSITIVE_INFINITY, 1])[0], "infinite");
  assert.equal(codeOf([])[0], codeOf("[]")[0]);
  assert.equal(codeOf([1, 2])[0], codeOf("[1, 2]")[0]);
  assert.equal(codeOf(new Float64Array(9_000))[0], codeOf(`[${"0, ".repeat(8_999)}0]`)[0]);
  // Rows of rows are written no further than any text is read.
  const row = new Float64Array(10_000).fill(0.123456789);
  assert.equal(codeOf(new Array(10_000).fill(row))[0], "text-too-long");
});

test("what is no number is refused with its place", () => {
  const refused = (given, words) =>
    assert.throws(() => read(given), { name: "TypeError", message: words });
  refused([0, 0, "0", 1], /`quaternion\[2\]` is a string, not a number/);
  refused(
    [
      [0, 0],
      [[0], 1],
    ],
    /`quaternion\[1\]\[0\]` is an object, not a number/,
  );
  // biome-ignore lint/suspicious/noSparseArray: a hole is what is asked.
  refused([0, , 0, 1], /`quaternion\[1\]` is (undefined|missing)/);
  refused(new Float64Array(10_001), /has 10001 elements; at most 10000/);
  refused(new BigInt64Array(4), /`quaternion\[0\]` is a bigint, not a number/);
  refused({ w: 1, x: 0, y: 0, z: 0 }, /`quaternion` is an object, not a text/);
  const id = { kind: "library", id: [1] };
  assert.throws(
    () => translate({ quaternion: [0, 0, 0, 1], from: id, to: id }),
    /`from.id` is an object/,
  );
  assert.throws(() => identify({ observations: [], name: 5 }), /`name` is a number, not a text/);
});
