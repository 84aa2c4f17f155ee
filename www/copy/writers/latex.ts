// LaTeX for a paper, with amsmath.
import { factors, listed, ordered, printed } from "./numbers.ts";
import type { Writer } from "./writer.ts";

const transposed = "^{\\mathsf{T}}";
const row = (numbers: readonly number[]) => listed(numbers, printed, " & ");
const column = (numbers: readonly number[]) =>
  `\\begin{bmatrix} ${row(numbers)} \\end{bmatrix}${transposed}`;

/** `R(q)^T` as it is printed. */
function formula(symbol: string): string {
  return symbol
    .replaceAll("(.)", "\\odot")
    .replaceAll("(x)", "\\otimes")
    .replaceAll(" o ", " \\circ ")
    .replaceAll(/d([qRev])\/dt/g, "\\dot{$1}")
    .replaceAll("Omega", "\\Omega")
    .replaceAll("omega", "\\omega")
    .replaceAll("delta", "\\delta")
    .replaceAll("]x", "]_{\\times}")
    .replaceAll("J_r", "J_{r}")
    .replaceAll("^-1", "^{-1}")
    .replaceAll("^T", transposed)
    .replaceAll("*", "^{*}");
}

export const latex: Writer = {
  comment: "%",
  lines: {
    quaternion: (value) => [`${formula(value.symbol)} = ${column(ordered(value).numbers)}`],
    matrix: ({ symbol, rows }) => [
      `${formula(symbol)} = \\begin{bmatrix}`,
      ...rows.map((numbers, at) => `  ${row(numbers)}${at < rows.length - 1 ? " \\\\" : ""}`),
      "\\end{bmatrix}",
    ],
    vector: ({ symbol, numbers }) => [`${formula(symbol)} = ${column(numbers)}`],
    "axis-angle": ({ axis, angleRad }) => [
      `u = ${column(axis)}, \\quad \\theta = ${printed(angleRad)}`,
    ],
    "rotation-vector": ({ vectorRad }) => [`\\theta u = ${column(vectorRad)}`],
    euler: ({ sequence: { axes, frame }, anglesRad }) => [
      `R = ${factors(axes, frame, anglesRad)
        .map(({ axis, angle }) => `R_${axis}(${printed(angle)})`)
        .join(" \\, ")}`,
    ],
  },
};
