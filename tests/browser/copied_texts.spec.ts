// What is copied as code: every text as it stands in tests/vectors/copied.json, and run where this
// machine can: three.js here, nalgebra by tests/rotation/copied.rs, Python by hand (check_copied.py).
import { readFileSync, writeFileSync } from "node:fs";
import { expect, test } from "@playwright/test";
// @ts-expect-error three.js has no types of its own.
import * as THREE from "three";
import { analyze, describeConvention, initSync, presets } from "../../pkg/quatlas.js";
import { columnValues, declaredValues, eulerValue, turnValues } from "../../www/copy/values.ts";
import { preview, written } from "../../www/copy/write.ts";
import type {
  Convention,
  Describe,
  Direction,
  EulerAxes,
  EulerFrame,
  PrintedMatrix,
  ReadReport,
} from "../../www/engine.ts";
import type { Copied } from "../../www/model/copied.ts";
import { type CodeFormat, canSay, formats } from "../../www/model/copy_formats.ts";
import { endWords } from "../../www/words/copy/end_values.ts";

const root = new URL("../../", import.meta.url);
initSync({ module: readFileSync(new URL("pkg/quatlas_bg.wasm", root)) });
const { hamilton, jpl } = presets();
const describe = describeConvention as Describe;

function read(text: string, convention: Convention, axes = "zyx", frame = "intrinsic") {
  const euler = { axes: axes as EulerAxes, frame: frame as EulerFrame };
  const outcome = analyze({ view: "read", quaternion: text, vector: "1 2 3", convention, euler });
  if (outcome.status !== "read") throw new Error(`${text} is not read`);
  return outcome;
}

const numbers = "0.1 -0.2 0.4 0.888819441731559";
/** JPL as Yoosefian 2021, eq. 18: from body to world, so the numbers are the conjugate. */
const yoosefian: Convention = { ...jpl, direction: "body-to-world" };
const active: Convention = { ...hamilton, function: "active" };
const origin = {
  version: "1.2.3",
  source: { quaternion: numbers },
  link: "https://example.org/#read",
};

/** Values whose order, signs and directions all show. */
function values(): Record<string, Copied> {
  const report = read(numbers, jpl);
  const halfSpace = read("180deg about [0.6, 0, 0.8]", hamilton);
  const columns = {
    hamilton: columnValues(report.hamilton, describe),
    jpl: columnValues(report.jpl, describe),
  };
  const turn = turnValues(report, describe);
  if (turn.axisAngle === undefined || columns.jpl.image === undefined)
    throw new Error("no rotation");
  return {
    hamilton: columns.hamilton.quaternion,
    jpl: columns.jpl.quaternion,
    "hamilton-conjugate": columns.hamilton.conjugate,
    "jpl-conjugate": columns.jpl.conjugate,
    opposite: turn.opposite,
    yoosefian: declaredValues(read(numbers, yoosefian), describe).quaternion,
    active: declaredValues(read(numbers, active), describe).quaternion,
    "norm-2": columnValues(read("2 0 0 0", hamilton).hamilton, describe).quaternion,
    "jpl-norm": columnValues(read("0.2 -0.1 0.4 0.8", jpl).jpl, describe).quaternion,
    "tiny-part": columnValues(read("1 1e-9 -2.5e-12 0", hamilton).hamilton, describe).quaternion,
    matrix: columns.hamilton.matrix,
    "jpl-matrix": columns.jpl.matrix,
    "jpl-inverse-matrix": columns.jpl.inverseMatrix,
    // For row vectors, as DirectXMath has it.
    "row-matrix": {
      kind: "matrix",
      symbol: "M",
      rows: report.jpl.matrix,
      does: endWords.endMatrix["as-printed"]("DirectXMath", { vectors: "row" } as PrintedMatrix),
    },
    "half-turn": columnValues(halfSpace.hamilton, describe).matrix,
    product: columns.jpl.left,
    vector: columns.jpl.image,
    "axis-angle": turn.axisAngle,
    "rotation-vector": turn.rotationVector,
    ZYX: eulerValue(report.euler),
    xyz: eulerOf("xyz", "extrinsic"),
    YXZ: eulerOf("yxz", "intrinsic"),
    ZXZ: eulerOf("zxz", "intrinsic"),
    yxy: eulerOf("yxy", "extrinsic"),
  };
}

const eulerOf = (axes: string, frame: string) => eulerValue(read(numbers, jpl, axes, frame).euler);

/** The body-to-world matrix of the page for what Hamilton's libraries make of a value. */
function rotationOf(value: Copied): readonly (readonly number[])[] | undefined {
  switch (value.kind) {
    case "vector":
      return undefined;
    case "matrix":
      return value.rows.length === 3 ? value.rows : undefined;
    case "quaternion": {
      const { w, x, y, z } = value.components;
      return read(`w=${w} x=${x} y=${y} z=${z}`, hamilton).hamilton.matrix;
    }
    default:
      return read(numbers, jpl).hamilton.matrix;
  }
}

/** Which coordinates that matrix takes to which; the one for row vectors is the transpose of the attitude's. */
function directionOf(name: string, value: Copied): Direction {
  if (value.kind === "quaternion") return value.hamiltonMatrix;
  return ["jpl-matrix", "row-matrix"].includes(name) ? "world-to-body" : "body-to-world";
}

const codeFormats = formats.map(({ id }) => id).filter((id): id is CodeFormat => id !== "numbers");

interface Case {
  value: string;
  format: CodeFormat;
  text: string;
  rotation?: readonly (readonly number[])[];
  direction?: Direction;
}

function cases(): Case[] {
  return Object.entries(values()).flatMap(([name, value]) =>
    codeFormats
      .filter((format) => canSay(format, value))
      .map((format) => {
        const rotation = rotationOf(value);
        const text = written(value, format, origin);
        const expected = rotation && { rotation, direction: directionOf(name, value) };
        return { value: name, format, text, ...expected };
      }),
  );
}

/** The texts for nalgebra as functions, which tests/rotation/copied.rs compiles and calls. */
function rustOf(all: Case[]): string {
  const turns = all.filter(({ format, rotation }) => format === "nalgebra" && rotation);
  const blocks = turns.map(({ value, text, rotation }) => {
    const matrix = text.includes("let m")
      ? "m"
      : text.includes("Unit")
        ? "q.to_rotation_matrix().into_inner()"
        : "UnitQuaternion::from_quaternion(q).to_rotation_matrix().into_inner()";
    const rows = JSON.stringify(rotation?.map((row) => row.map((number) => `${number}_f64`)));
    return `(${JSON.stringify(value)}, {\n${text}\n${matrix}\n}, ${rows.replaceAll('"', "")}),`;
  });
  return `[\n${blocks.join("\n")}\n]\n`;
}

/** What is written stands in files, which a change of the writers rewrites on request. */
function expectFile(name: string, text: string) {
  const url = new URL(`tests/vectors/${name}`, root);
  if (process.env["QUATLAS_WRITE_VECTORS"]) writeFileSync(url, text);
  expect(readFileSync(url, "utf8")).toBe(text);
}

test("every format writes every value as it is recorded", () => {
  const all = cases();
  expectFile("copied.json", `${JSON.stringify(all, null, 1)}\n`);
  expectFile("copied_nalgebra.rs", rustOf(all));
});

test("the four numbers stand where each constructor takes them, and nothing is conjugated", () => {
  const { jpl: value } = values();
  const calls: Partial<Record<CodeFormat, string>> = {
    eigen: "Eigen::Quaterniond q(0.888819441731559, 0.1, -0.2, 0.4);",
    scipy: "q = Rotation.from_quat([0.1, -0.2, 0.4, 0.888819441731559])",
    numpy: "q_xyzw = np.array([0.1, -0.2, 0.4, 0.888819441731559])",
    ros: "x: 0.1",
    nalgebra:
      "let q = UnitQuaternion::from_quaternion(Quaternion::new(0.888819441731559, 0.1, -0.2, 0.4));",
    javascript: "const q_xyzw = [0.1, -0.2, 0.4, 0.888819441731559];",
    three: "const q = new THREE.Quaternion(0.1, -0.2, 0.4, 0.888819441731559);",
    matlab: "q_wxyz = quaternion(0.888819441731559, 0.1, -0.2, 0.4);",
  };
  for (const [format, line] of Object.entries(calls)) {
    expect(value && preview(value, format as CodeFormat, origin)).toBe(line);
  }
});

test("the comment says what a quaternion of JPL is to a library of Hamilton's", () => {
  const text = (name: string) => {
    const value = values()[name];
    return value && written(value, "eigen", origin).split("\n").slice(0, -1).join("\n");
  };
  expect(text("hamilton")).toBe(
    "// q: Hamilton (ij = k), body to world; Quaterniond takes w x y z",
  );
  expect(text("jpl")).toBe(
    "// q: JPL (ij = -k), world to body; Quaterniond takes w x y z\n" +
      "// the numbers as they are: Eigen multiplies ij = k, so toRotationMatrix() of them is R(q) = C(q)^T, body to world",
  );
  // The conjugate components: the library's matrix goes the other way.
  expect(text("yoosefian")).toContain("is R(q) = C(q)^T, world to body");
  expect(text("active")).toContain("is R(q), for coordinates world to body");
  expect(text("hamilton-conjugate")).toContain("q*: Hamilton (ij = k), world to body");
  expect(text("norm-2")).toContain("its norm is 2, not 1");
});

test("in all 32 conventions the direction that a comment names is that of the matrix", () => {
  const axes = {
    order: ["scalar-first", "scalar-last"],
    handedness: ["right", "left"],
    function: ["passive", "active"],
    direction: ["body-to-world", "world-to-body"],
    perturbation: ["local", "global"],
  } as const;
  let conventions: Partial<Convention>[] = [{}];
  for (const [axis, both] of Object.entries(axes)) {
    conventions = conventions.flatMap((one) => both.map((value) => ({ ...one, [axis]: value })));
  }
  expect(conventions).toHaveLength(32);
  for (const convention of conventions as Convention[]) {
    const report = read(numbers, convention);
    const { declared, hamilton: attitude, jpl: transposed, paired, rules } = report;
    const { w, x, y, z } = declared.quaternion;
    const rotation = read(`w=${w} x=${x} y=${y} z=${z}`, hamilton).hamilton.matrix;
    const { quaternion } = declaredValues({ declared, paired }, describe);
    const isBodyToWorld = quaternion.hamiltonMatrix === "body-to-world";
    expect(isBodyToWorld).toBe(rules.isCanonical);
    expect(rotation).toEqual(isBodyToWorld ? attitude.matrix : transposed.matrix);
  }
});

test("three.js makes the rotation of the page of every text", () => {
  const turns = cases().filter(({ format, rotation }) => format === "three" && rotation);
  expect(turns.length).toBeGreaterThan(12);
  for (const { value, text, rotation } of turns) {
    const matrix: { elements: number[] } = new Function(
      "THREE",
      `${text}
      if (typeof M !== "undefined") return M;
      if (typeof e !== "undefined") return new THREE.Matrix4().makeRotationFromEuler(e);
      return new THREE.Matrix4().makeRotationFromQuaternion(q.normalize());`,
    )(THREE);
    const size = matrix.elements.length === 16 ? 4 : 3;
    rotation?.flat().forEach((number, at) => {
      const element = matrix.elements[(at % 3) * size + Math.floor(at / 3)];
      expect(element, `${value}, element ${at}`).toBeCloseTo(number, 14);
    });
  }
});

test("a quaternion that was copied is read again as the same attitude", () => {
  for (const name of [
    "hamilton",
    "jpl",
    "hamilton-conjugate",
    "yoosefian",
    "norm-2",
    "tiny-part",
  ]) {
    const value = values()[name];
    if (value?.kind !== "quaternion") throw new Error(`${name} is no quaternion`);
    for (const format of codeFormats) {
      // Whatever order is declared: the text tells its own.
      for (const order of ["scalar-first", "scalar-last"] as const) {
        const declared = { ...value.convention, order };
        const { quaternion } = read(written(value, format, origin), declared);
        const { w, x, y, z } = quaternion.components;
        expect({ w, x, y, z }, `${name} as ${format}`).toEqual(value.components);
      }
    }
  }
});

test("a test vector tells another program all it needs", () => {
  const value = values()["jpl"];
  const vector = JSON.parse(value ? written(value, "test-vector", origin) : "");
  const report: ReadReport = read(numbers, jpl);
  expect(vector).toEqual({
    testVector: 1,
    quatlas: "1.2.3",
    kind: "quaternion",
    is: "q: JPL (ij = -k), x y z w, world to body",
    convention: { ...jpl, product: "ij = -k" },
    numbers: { x: 0.1, y: -0.2, z: 0.4, w: 0.888819441731559 },
    array: [0.1, -0.2, 0.4, 0.888819441731559],
    expected: {
      matrix: report.jpl.matrix,
      form: "C(q) = R(q)^T",
      direction: "world to body",
      takes: "columns of coordinates in the world frame to coordinates in the body frame",
    },
    source: { quaternion: numbers },
    link: "https://example.org/#read",
  });
});

test("nothing that is copied has a minus zero, and only LaTeX is without a plain number", () => {
  for (const { text, format, value } of cases()) {
    expect(text, `${value} as ${format}`).not.toMatch(/-0(\.0)?\b(?![.\d])/);
    expect(text).not.toMatch(/NaN|undefined|Infinity/);
    // biome-ignore lint/suspicious/noControlCharactersInRegex: all of ASCII
    expect(text).toMatch(/^[\x00-\x7f]*$/);
  }
});
