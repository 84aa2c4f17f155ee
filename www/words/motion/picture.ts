// The words of the picture of Motion.

export const name = "The motion of the body";
export const file = "quatlas-motion.svg";
export const play = "Play";
export const pause = "Pause";
export const back = "One step back";
export const forward = "One step on";
export const moment = "Moment";
export const speed = "Speed";
export const speeds = { "½": "half", "1": "usual", "2": "double" };
export const at = (seconds: string) => `t = ${seconds} s`;
export const says = (mistake: string | undefined) =>
  `B is the body, the dotted line the way of its x axis.${mistake === undefined ? "" : ` Dashed: ${mistake}.`}`;
export const nothing = "Without a rate and a duration nothing moves.";
