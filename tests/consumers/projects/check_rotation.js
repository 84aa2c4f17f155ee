// As check.js, of numbers: an entry, and another one whose rotations it takes.
globalThis.checkRotation = ({ JPL, Rotation }, other) => {
  const yawed = Rotation.fromQuat([0, 0, Math.SQRT1_2, Math.SQRT1_2], JPL);
  const rolled = other.Rotation.fromAxisAngle([1, 0, 0], 90, "deg");
  // The body is yawed; what is rolled on it looks along its own z, which is the world's x.
  const found = yawed
    .andThen(rolled)
    .apply([0, 0, 1])
    .map((number) => number.toFixed(9));
  if (found.join() !== "1.000000000,0.000000000,0.000000000") throw new Error(found.join());
  try {
    Rotation.fromQuat([0, 0, 0, 0], JPL);
  } catch ({ code }) {
    if (code === "zero-quaternion") return "ok";
  }
  throw new Error("four zeros were taken for a rotation");
};

if (typeof document === "object") {
  addEventListener("error", ({ message }) => {
    document.title = message;
  });
}
