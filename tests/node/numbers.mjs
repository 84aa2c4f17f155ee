// What the tests of numbers have in common.
import assert from "node:assert/strict";

/** Whether numbers are near, each to the same distance. */
export function near(found, expected, tolerance = 1e-15) {
  assert.equal(found.length, expected.length);
  expected.forEach((number, at) => {
    assert.ok(Math.abs(found[at] - number) <= tolerance, `${found} is not ${expected}`);
  });
}

/** Numbers between −1 and 1, the same in every run (SplitMix32). */
export function numbersFrom(seed) {
  let state = seed;
  return () => {
    state = (state + 0x9e3779b9) | 0;
    let mixed = state ^ (state >>> 16);
    mixed = Math.imul(mixed, 0x21f0aaad);
    mixed ^= mixed >>> 15;
    mixed = Math.imul(mixed, 0x735a2d97);
    return ((mixed ^ (mixed >>> 15)) >>> 0) / 2 ** 31 - 1;
  };
}

/** Whether a call throws a `QuatlasError` with this code and with a hint. */
export const refuses = (code, call) =>
  assert.throws(call, (error) => {
    assert.ok(error.name === "QuatlasError" && error instanceof Error, String(error));
    assert.equal(error.code, code, error.message);
    assert.ok(error.hint.length > 5 && error.message.endsWith(error.hint));
    return true;
  });
