// A value as code: its comment and its lines. Loaded when a copy first needs it.
import type { Copied } from "../model/copied.ts";
import type { CodeFormat } from "../model/copy_formats.ts";
import { says } from "../words/copy/comments.ts";
import { eigen } from "./writers/cpp.ts";
import { javascript, three } from "./writers/javascript.ts";
import { json, type Origin, testVector } from "./writers/json.ts";
import { latex } from "./writers/latex.ts";
import { matlab } from "./writers/matlab.ts";
import { ros } from "./writers/message.ts";
import { numpy, scipy } from "./writers/python.ts";
import { nalgebra } from "./writers/rust.ts";
import type { Writer } from "./writers/writer.ts";

type Language = Exclude<CodeFormat, "json" | "test-vector">;

const writers: Record<Language, Writer> = {
  eigen,
  scipy,
  numpy,
  ros,
  nalgebra,
  javascript,
  three,
  matlab,
  latex,
};

/** The text of a value in a format that can say it. */
export function written(value: Copied, format: CodeFormat, origin: Origin): string {
  if (format === "json") return json(value);
  if (format === "test-vector") return testVector(value, origin);
  const { comment } = writers[format];
  const comments = says(value, format).map((line) => `${comment} ${line}`);
  return [...comments, ...linesOf(value, format)].join("\n");
}

/** The first line of code, for the menu. */
export function preview(value: Copied, format: CodeFormat, origin: Origin): string {
  if (format === "json") return json(value);
  if (format === "test-vector") return testVector(value, origin).replace(/\s+/g, " ");
  return linesOf(value, format)[0] ?? "";
}

function linesOf(value: Copied, format: Language): string[] {
  const lines = writers[format].lines[value.kind] as ((value: Copied) => string[]) | undefined;
  return lines?.(value) ?? [];
}
