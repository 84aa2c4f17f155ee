// The words of the Libraries view and of the field in which a library is picked.
import type { Code, Known } from "../engine.ts";
import { notEstablished } from "./library_behaviour.ts";

export const librariesWords = {
  input: "Input",
  title: "What libraries mean by four numbers",
  find: "Find a library",
  findExample: "name, module, language, xyzw, JPL …",
  legend: (
    <>
      <strong>R</strong> is the matrix of Hamilton's active rotation, <var>R</var>(<var>q</var>){" "}
      <var>v</var> = <var>q</var> <var>v</var> <var>q</var>*, and <strong>C</strong> its transpose.
      Where no call of a library rotates a vector, what acts first follows from its matrix. A dash
      means {notEstablished}.
    </>
  ),
  none: "No record has all these words. Try one of them, or",
  showAll: (count: number) => `show all ${count}`,
  /** How many records are shown, and how each is known. */
  counted: (shown: number, all: number, known: readonly (readonly [Known, number])[]) => {
    const total = shown === all ? `${all} records` : `${shown} of ${all}`;
    const parts = known.map(([how, count]) => `${count} ${countWords[how]}`);
    return parts.length === 0 ? `${total}.` : `${total}: ${parts.join(", ")}.`;
  },
  /** The heads of the columns, in the order of the cells. */
  columns: [
    "Library",
    "Version",
    "Known",
    "Array",
    "Constructor",
    "Product",
    "Rotates by",
    "Matrix as printed",
    "a * b: first",
    "In short",
  ],
  /** What a screen reader hears when the table changes. */
  spoken: (shown: number, all: number, opened: string | undefined) =>
    `${shown} of ${all} libraries.${
      opened === undefined ? "" : ` The record of ${opened} is open.`
    }`,
} as const;

/** What is said after a number of records. */
const countWords: Record<Known, string> = {
  run: "run",
  read: "known from the source",
  documented: "only from the documentation",
};

export const recordWords = {
  title: (name: string) => `The record of ${name}`,
  from: "Translate from",
  to: "Translate to",
  link: "link to this record",
  copiedLink: "the link to this record",
  means: "What it means",
  called: "Called",
  direction: "Direction",
  takes: (action: string, coordinates: string) =>
    `${action}(q) takes ${coordinates}, as documented`,
  euler: "Euler angles",
  eulerCall: (call: string, means: string) => (
    <>
      <code>{call}</code> is <code>{means}</code>
    </>
  ),
  axisAngle: "+θ about z",
  ofMatrix: "Of a matrix",
  slerp: "slerp",
  nonUnit: "Norm 2",
  zero: "Zero",
  known: "How it is known",
  calls: "Calls",
  source: "Source",
  code: {
    construct: "construct",
    rotate: "rotate v",
    matrix: "matrix",
    product: "product",
    fromMatrix: "of a matrix",
    print: "print",
  } satisfies Record<keyof Code, string>,
  copiedCall: (name: string) => `the call: ${name}`,
} as const;

export const pickerWords = {
  list: (label: string) => `${label}: libraries and conventions`,
  none: (asked: string) =>
    `No library here is called “${asked}”. Try a module, a class or a language; or choose a convention.`,
  conventions: "Conventions",
  libraries: "Libraries",
  convention: {
    hamilton: { name: "Hamilton", about: "w x y z, ij = k, body → world" },
    jpl: { name: "JPL", about: "x y z w, ij = −k, world → body (Shuster)" },
    custom: { name: "Custom convention…", about: "five axes, each by itself" },
  },
  /** A word by which all conventions are found. */
  conventionWord: "convention",
} as const;
