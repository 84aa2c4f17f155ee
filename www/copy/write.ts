// A value as code: its comment and its lines. Loaded when a copy first needs it.
import { says } from "../words/copy.ts";
import { type Copied, directionOfR } from "./copied.ts";
import { eigen } from "./cpp.ts";
import type { CodeFormat } from "./formats.ts";
import { javascript, three } from "./javascript.ts";
import { json, type Origin, testVector } from "./json.ts";
import { latex } from "./latex.ts";
import { matlab } from "./matlab.ts";
import { ros } from "./message.ts";
import { numpy, scipy } from "./python.ts";
import { nalgebra } from "./rust.ts";
import type { Writer } from "./writer.ts";

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
  const comments = says(value, format, directionOfR).map((line) => `${comment} ${line}`);
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
