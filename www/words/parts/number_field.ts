// What the fields of the result are called, and what stands under one that cannot be read.

/** What stands under a number that cannot be read, while it is edited. */
export const numberProblem = (
  typed: string,
  { code, message, expected }: { code: string; message: string; expected: string },
) => {
  if (typed.trim() === "") return "A number is missing here.";
  // Of the core that has no sentences.
  return message === "" ? `This is no number (${code}).` : `${message}. Expected: ${expected}.`;
};

export const fieldWords = {
  component: (group: string, name: string) => `${group}, ${name}`,
  entry: (matrix: string, row: number, column: number) => `${matrix}, row ${row}, column ${column}`,
  angleIn: (unit: string) => `angle in ${unit}`,
  axis: (name: string) => `axis, ${name}`,
  rotationVector: (name: string) => `rotation vector, ${name}`,
  eulerAngle: (name: string, unit: string) => `${name} in ${unit}`,
  degrees: "degrees",
  radians: "radians",
  about: "about",
} as const;
