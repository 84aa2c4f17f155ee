// The words of a declared convention that is neither preset.
import type { ComponentChildren } from "preact";

export const yours = "Your convention";
export const named = (symbol: string) => `${symbol} as declared`;
export const matrix = "matrix of q as declared";
export const coordinates = {
  passive: (arrow: string) => `the coordinates of x, ${arrow}`,
  active: (arrow: string) => `x turned, on the same axes; by the matrix that passively is ${arrow}`,
};
export const matrixDoes = {
  passive: (arrow: string) => arrow,
  active: (arrow: string) => `turns x; passively it is ${arrow}`,
};
export const multiplies = "What this convention multiplies";
export const components = (isCanonical: boolean) =>
  `Components: ${isCanonical ? "those of Hamilton" : "the conjugate of Hamilton's"}.`;
export const labels = (product: ComponentChildren, made: ComponentChildren) => (
  <>
    By labels {product} is {made}.
  </>
);
export const camera = (product: ComponentChildren) => (
  <>A camera C on the body B: {product} is its quaternion in the world.</>
);
export const increment = (product: ComponentChildren) => <>A small turn: {product}.</>;
export const bodyRate = (derivative: ComponentChildren) => <>The body's rate: {derivative}.</>;
