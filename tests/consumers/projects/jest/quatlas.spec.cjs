require("../check.js");

test("quatlas is required", () => {
  expect(checkQuatlas(require("quatlas"))).toBe("ok");
});
