// The words of the picture of the frames.

export const name = "The frames where they stand";
export const says = (names: string) =>
  `Each frame with its axes x, y and z: ${names}. The dotted way is that of the answer.`;
export const nothing = "Without positions all frames stand at one place.";
export const file = "quatlas-frames.svg";
