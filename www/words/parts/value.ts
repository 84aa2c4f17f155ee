// The words of numbers anywhere.

export const rowByRow = (matrix: string) => `${matrix}, row by row`;
export const beyondDouble = "beyond the range of a double";
