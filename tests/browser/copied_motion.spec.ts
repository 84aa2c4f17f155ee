// What Motion copies as code: what is a rotation in every format, what is none in none that would make one of it.
import { readFileSync } from "node:fs";
import { expect, test } from "@playwright/test";
import { analyze, describeConvention, initSync, presets } from "../../pkg/quatlas.js";
import {
  covarianceValue,
  derivativeValue,
  incrementValues,
  omegaValue,
  pathValues,
  pointValues,
  rateValues,
  turnedValue,
} from "../../www/copy/motion_values.ts";
import { written } from "../../www/copy/write.ts";
import type { Describe } from "../../www/engine.ts";
import type { Copied } from "../../www/model/copied.ts";
import { type CodeFormat, canSay, formats } from "../../www/model/copy_formats.ts";

initSync({ module: readFileSync(new URL("../../pkg/quatlas_bg.wasm", import.meta.url)) });
const convention = presets().jpl;
const describe = describeConvention as Describe;
const origin = { version: "1.2.3" };

/** A quarter turn about z, turned about its own x, in a JPL quaternion: Ω and all sides show. */
function values(): Record<string, Copied> {
  const report = analyze({
    view: "motion",
    quaternion: "0 0 √½ √½",
    convention,
    rate: "0.1 0.2 0.4",
    duration: "2 s",
    steps: 8,
    increment: "0.02 0 0",
    covariance: "1 4 9",
    point: "1 2 3",
  });
  if (report.status !== "motion") throw new Error("it is answered");
  const { increment, derivative, path, covariance, point } = report;
  const [row] = derivative?.quaternions ?? [];
  const [after] = increment?.plus ?? [];
  if (!(increment && derivative && path && covariance && point && row && after)) {
    throw new Error("all is asked");
  }
  const ofIncrement = incrementValues(increment, after, describe);
  const ofRate = rateValues(derivative);
  const ofPath = pathValues(path, convention, describe);
  const { byBodyTurn, byComponents } = pointValues(point, "x y z w");
  return {
    after: turnedValue(after, describe),
    error: ofIncrement.error,
    matrix: ofIncrement.matrix,
    end: ofPath.end,
    turn: ofPath.turn,
    increment: ofIncrement.world,
    smallQuaternion: ofIncrement.smallQuaternion,
    smallMatrix: ofIncrement.smallMatrix,
    derivative: derivativeValue(row),
    omega: omegaValue(row),
    matrixRate: ofRate.matrix,
    jacobian: ofRate.jacobian,
    path: ofPath.path,
    covariance: covarianceValue(covariance, "world"),
    byBodyTurn,
    byComponents,
  };
}

test("a rotation has every format, and of anything else none makes a rotation", () => {
  const said = Object.fromEntries(
    Object.entries(values()).map(([name, value]) => [
      name,
      formats.map(({ id }) => id).filter((format) => canSay(format, value)),
    ]),
  );
  const all = formats.map(({ id }) => id);
  const without = (...missing: string[]) => all.filter((format) => !missing.includes(format));
  expect(said).toEqual({
    after: all,
    error: all,
    matrix: without("ros"),
    end: all,
    turn: without("ros"),
    increment: without("scipy"),
    smallQuaternion: without("scipy", "ros"),
    smallMatrix: without("scipy", "ros"),
    derivative: without("scipy", "ros"),
    omega: without("scipy", "ros"),
    matrixRate: without("scipy", "ros"),
    jacobian: without("scipy", "ros"),
    path: without("scipy", "ros", "three", "nalgebra"),
    covariance: without("scipy", "ros"),
    byBodyTurn: without("scipy", "ros"),
    byComponents: without("scipy", "ros", "three"),
  });
});

test("the texts have the order, the sign and the shape of what they are", () => {
  const all = values();
  const text = (name: string, format: CodeFormat) => {
    const value = all[name];
    if (value === undefined) throw new Error(name);
    return written(value, format, origin);
  };
  // JPL, world to body: q̇ = ½ ω ⊗ q; by hand of q = (0, 0, √½, √½), ω = (0.1, 0.2, 0.4).
  expect(text("derivative", "numpy")).toBe(
    "# dq/dt: per second, of the quaternion x y z w, ij = -k, world to body; no rotation\n" +
      "v = np.array([-0.03535533905932738, 0.10606601717798214, 0.14142135623730953, -0.14142135623730953])",
  );
  expect(text("derivative", "eigen")).toContain("Eigen::Vector4d v(-0.0353553");
  expect(text("derivative", "nalgebra")).toContain("Vector4::new(-0.0353553");
  expect(text("derivative", "latex")).toContain("\\dot{q} = ");
  // Cheng 2018, eq. 2.36 for JPL: Ω = [−[ω]×, ω; −ωᵀ, 0].
  expect(text("omega", "javascript")).toBe(
    "// Omega: dq/dt = Omega q / 2, on x y z w\nconst M = [\n" +
      "  [0, 0.4, -0.2, 0.1],\n  [-0.4, 0, 0.1, 0.2],\n  [0.2, -0.1, 0, 0.4],\n  [-0.1, -0.2, -0.4, 0],\n];",
  );
  // The body is turned by 90°: its x is the y of the world.
  expect(text("increment", "matlab")).toMatch(
    /% delta: small turn in rad on the world axes\nv = \[\S+; 0\.02; 0\];/,
  );
  expect(text("covariance", "numpy")).toMatch(
    /P: covariance on the world axes\nM = np\.array\(\[\[4(\.0)?, /,
  );
  expect(text("byComponents", "eigen")).toContain("Eigen::Matrix<double, 3, 4> M;");
  expect(text("byComponents", "nalgebra")).toContain("Matrix3x4::new(");
  expect(text("path", "eigen")).toContain("Eigen::Matrix<double, 9, 5> M;");
  expect(text("after", "scipy")).toContain("Rotation.from_quat([");
  const { expected, numbers } = JSON.parse(text("smallQuaternion", "test-vector"));
  expect([expected, numbers]).toEqual([undefined, { numbers: [0.01, 0, 0, 1] }]);
});
