// The words of the two columns of a result.

/** Where there is room for one column. */
export const shownColumn = "Shown in";
export const inverseOf = (matrix: string) => `inverse of ${matrix}`;
export const conjugateOf = (convention: string) => `${convention} conjugate`;
export const conjugate = "the conjugate";
export const inverseQuaternionOf = (convention: string) => `${convention} inverse`;
export const inverse = "the inverse: conjugate / norm²";
export const unitOf = (convention: string) => `${convention} unit quaternion`;
export const unit = "the same rotation with norm 1";
export const leftProductOf = (convention: string) => `${convention} left product matrix`;
export const rightProductOf = (convention: string) => `${convention} right product matrix`;
/** Which numbers a product matrix multiplies, and of which q it is. */
export const onOrder = {
  unit: (order: string) => `on ${order}`,
  typed: (order: string) => `on ${order}, of q with its norm`,
};
