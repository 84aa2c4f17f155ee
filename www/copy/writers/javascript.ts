// JavaScript as plain arrays, and with three.js.
import { arrayOf } from "../../model/component_order.ts";
import type { CopiedEuler, Rows } from "../../model/copied.ts";
import { listed, ordered, plain } from "./numbers.ts";
import type { Writer } from "./writer.ts";

const list = (numbers: readonly number[]) => `[${listed(numbers, plain)}]`;
const lined = (rows: Rows, written: (row: readonly number[]) => string) =>
  rows.map((row) => `  ${written(row)},`);

export const javascript: Writer = {
  comment: "//",
  lines: {
    quaternion: (value) => {
      const { name, numbers } = ordered(value);
      return [`const ${name} = ${list(numbers)};`];
    },
    matrix: ({ rows }) => ["const M = [", ...lined(rows, list), "];"],
    vector: ({ numbers }) => [`const v = ${list(numbers)};`],
    "axis-angle": ({ axis, angleRad }) => [
      `const axis = ${list(axis)};`,
      `const angle = ${plain(angleRad)};`,
    ],
    "rotation-vector": ({ vectorRad }) => [`const v = ${list(vectorRad)};`],
    euler: ({ anglesRad }) => [`const angles = ${list(anglesRad)};`],
  },
};

const threeVector = (numbers: readonly number[]) =>
  `new THREE.Vector${numbers.length}(${listed(numbers, plain)})`;

export const three: Writer = {
  comment: "//",
  lines: {
    quaternion: ({ components }) => [
      `const q = new THREE.Quaternion(${listed(arrayOf(components, "scalar-last"), plain)});`,
    ],
    // set() takes rows, although three.js keeps its matrices column by column.
    matrix: ({ rows }) => [
      `const M = new THREE.Matrix${rows.length}().set(`,
      ...lined(rows, (row) => listed(row, plain)),
      ");",
    ],
    vector: ({ numbers }) => [`const v = ${threeVector(numbers)};`],
    "axis-angle": ({ axis, angleRad }) => [
      `const q = new THREE.Quaternion().setFromAxisAngle(${threeVector(axis)}, ${plain(angleRad)});`,
    ],
    "rotation-vector": ({ vectorRad }) => [
      `const v = ${threeVector(vectorRad)};`,
      "const q = new THREE.Quaternion().setFromAxisAngle(v.clone().normalize(), v.length());",
    ],
    euler: (value) => [`const e = new THREE.Euler(${threeAngles(value)});`],
  },
};

/**
 * The angles about x, y and z, and the order about the moving axes; turns about the fixed axes are
 * those about the moving ones in reverse.
 */
function threeAngles({ sequence: { axes, frame }, anglesRad }: CopiedEuler): string {
  const order = frame === "intrinsic" ? [...axes] : [...axes].reverse();
  const angles = ["x", "y", "z"].map((axis) => anglesRad[axes.indexOf(axis)] ?? 0);
  return `${listed(angles, plain)}, "${order.join("").toUpperCase()}"`;
}
