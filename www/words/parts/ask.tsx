// The words of what is asked.
import type { ComponentChildren } from "preact";

export const input = "Input";
export const quaternion = "quaternion";
export const vector = "vector";
export const meantAs = "The text is meant as";
export const custom = "Custom";
export const readAs = "Read as";
export const quaternionIn = (letters: ComponentChildren) => <>quaternion {letters}</>;
export const norm = "norm";
export const shortAddressWords =
  "The text is too long for an address: links to this page hold the numbers that were read.";
