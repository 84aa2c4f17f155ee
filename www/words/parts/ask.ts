// The words of what is asked.

export const input = "Input";
export const quaternion = "quaternion";
export const vector = "vector";
export const meantAs = "The text is meant as";
export const custom = "Custom";
export const readAs = "Read as";
export const norm = "norm";
