// The words of a product of many factors.

export const title = "More than two";
export const factor = (place: number) => `factor ${place}`;
export const inverse = "inverted";
export const inverts = (place: number) => `factor ${place} inverted`;
export const reverse = "multiplied in reverse";
export const removes = (place: number) => `Remove factor ${place}`;
export const remove = "Remove";
export const add = "Add a factor";

export const product = "product";
export const productIn = (convention: string) => `the product, ${convention}`;
export const itsInverse = "its inverse";
export const inverseIn = (convention: string) => `the inverse of the product, ${convention}`;
export const matrixIn = (letter: string) => `${letter} of the product of all factors`;
export const rotationVector = "rotation vector";
export const turn = (angle: string, axis: string) => `rad · ${angle} about ${axis}`;
export const euler = (sequence: string) => `Euler angles ${sequence}`;
export const mean = "the mean of the factors, as declared";
export const noMean = "The factors have no mean: several rotations are as near to all of them.";
