// The words of one rotation in all conventions.
import type { Convention } from "../../engine.ts";

export const title = "The same rotation in all 16 conventions";
export const rows = "The conventions, row by row";
export const unread = "The text has to be read first.";
export const lead =
  "Find your four numbers: the rows below them are the conventions that write them so. What they multiply, and on which side, tells which is yours; choosing a row declares it.";
export const heads = [
  "Convention",
  "Its matrix",
  "Camera C on B",
  "Small rotation",
  "q̇ of the body's rate",
  "Written as",
];
export const array = (letters: string) => `the numbers ${letters}`;
export const meaning = (product: string, does: Convention["function"], arrow: string) =>
  `${product}, ${does}, ${arrow}`;
/** The documents that spell a quaternion. */
export const cheng = "Cheng";
export const yoosefian = "Yoosefian";
export const lecture = "ME 495";
export const guide = "guide";

const part = (of: string) => (
  <>
    <var>q</var>
    <sub>{of}</sub>
  </>
);
/** That of B in W beside that of C in B. */
export const chain = (isBodyRight: boolean) =>
  isBodyRight ? (
    <>
      {part("BC")}∘{part("WB")}
    </>
  ) : (
    <>
      {part("WB")}∘{part("BC")}
    </>
  );
