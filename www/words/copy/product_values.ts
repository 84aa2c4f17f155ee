// What the copied matrix of a product says that it does; plain ASCII.
import type { Frame } from "../../engine.ts";

const frames: Record<Frame, string> = {
  world: "world",
  body: "body",
  "second-body": "second body",
};

export const framesWords = (start: Frame, end: Frame) =>
  `${frames[start]} to ${frames[end]}, multiplies columns`;
