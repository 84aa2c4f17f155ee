import "../check.js";
import * as quatlas from "quatlas";
import { expect, test } from "vitest";

test("quatlas is imported", () => {
  expect(checkQuatlas(quatlas)).toBe("ok");
});
