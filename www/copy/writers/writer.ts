// What a language writes: for each kind of value that it can say, lines of code without the comment.
import type { Copied, Kind } from "../../model/copied.ts";

export type Lines = {
  [Of in Kind]?: (value: Extract<Copied, { kind: Of }>) => string[];
};

export interface Writer {
  /** What begins a comment. */
  comment: string;
  lines: Lines;
}
