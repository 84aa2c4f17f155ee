// The words of what a convention multiplies.
import type { ComponentChildren } from "preact";

export const multiplies = "What this convention multiplies";
export const multipliesAs = (convention: string) => `What ${convention} multiplies`;
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
/** By the axes of a small rotation. */
export const increment = {
  local: (product: ComponentChildren) => <>A small rotation about the body's axes: {product}.</>,
  global: (product: ComponentChildren) => <>A small rotation about the world's axes: {product}.</>,
};
export const bodyRate = (derivative: ComponentChildren) => (
  <>The body's angular velocity: {derivative}.</>
);
