// How numbers are written: pure functions, without a page.
import { expect, test } from "@playwright/test";
import {
  alignedRows,
  exactArray,
  shown,
  shownArray,
  shownAxis,
} from "../../../www/number/format.ts";

test("numbers are rounded for reading and never lose their size", () => {
  expect(shown(0.70710678118, "4")).toBe("0.7071");
  expect(shown(-0.70710678118, "6")).toBe("−0.707107");
  expect(shown(-Math.SQRT1_2, "all")).toBe("−0.7071067811865476");
  expect(shown(1, "6")).toBe("1");
  expect(shown(1.5e-9, "6")).toBe("1.5e−9");
  expect(shown(2.5e300, "4")).toBe("2.5e300");
  expect(shown(1e21, "all")).toBe("1e21");
  expect(shown(-0.00001234567, "4")).toBe("−1.2346e−5");
});

test("what is rounding beside a larger number is shown as zero, except in all digits", () => {
  expect(shownArray([1, -7.85e-17, 0], "6")).toBe("[1, 0, 0]");
  expect(shownArray([1, -7.85e-17, 0], "all")).toBe("[1, −7.85e−17, 0]");
  expect(shownArray([1e-9, -2e-9], "6")).toBe("[1e−9, −2e−9]");
});

test("decimal points of a column stand below each other", () => {
  expect(
    alignedRows(
      [
        [0.5, -1],
        [-0.25, 0],
      ],
      "4",
    ),
  ).toEqual([
    [" 0.5000", "−1"],
    ["−0.2500", " 0"],
  ]);
});

test("a copy reads back as the same double", () => {
  const numbers = [0.1, 1 / 3, 5e-324, 1.7976931348623157e308, -Math.SQRT1_2];
  expect(JSON.parse(exactArray(numbers))).toEqual(numbers);
});

test("an axis that is one of the frame has its name", () => {
  expect(shownAxis([0, 0, 1], "6")).toBe("z");
  expect(shownAxis([0, -1, 0], "6")).toBe("−y");
  expect(shownAxis([0.6, 0, 0.8], "4")).toBe("[0.6000, 0, 0.8000]");
});
