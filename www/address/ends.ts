// The ends of a translation in the address: `eigen`, `eigen~scalar-first~world-to-body`, `:jpl`, or
// the five axes `:scalar-last,left,passive,world-to-body,local`.
import type { Convention, Endpoint } from "../engine.ts";
import { axes, axisValues } from "../model/conventions.ts";
import { presetChoices } from "../model/page_state.ts";
import { namedConventions } from "../values.ts";

/** Whether there is a library with this id. */
export type IsLibrary = (id: string) => boolean;

const conventionMark = ":";
const partMark = "~";
const axisMark = ",";

export function endToText(end: Endpoint): string {
  if (end.kind === "library") {
    return [end.id, end.order, end.direction].filter((part) => part !== undefined).join(partMark);
  }
  const { convention } = end;
  const name = presetChoices.find((name) =>
    axes.every((axis) => namedConventions[name][axis] === convention[axis]),
  );
  return conventionMark + (name ?? axes.map((axis) => convention[axis]).join(axisMark));
}

/** Nothing for a text that names no end. */
export function endFromText(text: string | null, isLibrary: IsLibrary): Endpoint | undefined {
  if (text === null) return undefined;
  if (!text.startsWith(conventionMark)) return libraryFrom(text, isLibrary);
  const name = text.slice(conventionMark.length);
  const known = presetChoices.find((other) => other === name);
  const convention = known ? namedConventions[known] : fiveFrom(name);
  return convention && { kind: "convention", convention: { ...convention } };
}

function libraryFrom(text: string, isLibrary: IsLibrary): Endpoint | undefined {
  const [id = "", ...parts] = text.split(partMark);
  if (!isLibrary(id)) return undefined;
  const end: Endpoint = { kind: "library", id };
  const order = axisValues.order.find((value) => parts.includes(value));
  const direction = axisValues.direction.find((value) => parts.includes(value));
  return { ...end, ...(order && { order }), ...(direction && { direction }) };
}

function fiveFrom(text: string): Convention | undefined {
  const [order, handedness, does, direction, perturbation, ...rest] = text.split(axisMark);
  const five = { order, handedness, function: does, direction, perturbation };
  const isWhole = axes.every((axis) =>
    (axisValues[axis] as readonly string[]).includes(five[axis] ?? ""),
  );
  return isWhole && rest.length === 0 ? (five as Convention) : undefined;
}
