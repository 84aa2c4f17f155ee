// The words of a rotation about an axis, and the rest.

export const title = "Twist and swing";
export const axis = "axis";
export const angle = "twist about the axis";
export const twist = "the twist, as declared";
export const swing = "the swing after it, on the world's axes";
export const bodySwing = "the swing on the twisted body's axes";
export const turn = (angle: string, axis: string) => `${angle} about ${axis}`;
export const noTwist =
  "Half a turn about an axis at a right angle: every twist is as near as any other.";
