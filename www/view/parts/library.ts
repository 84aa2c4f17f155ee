// What is established of a library, and how it is named beside its behaviour.
import type {
  ComponentOrder,
  Endpoint,
  Engine,
  Family,
  Group,
  Library,
  LibraryDescription,
} from "../../engine.ts";
import { lettersOf } from "../../words/conventions.ts";
import {
  customConvention,
  familyWords,
  groupNames,
  kindNames,
  knownWords,
  numbersWords,
} from "../../words/library_behaviour.ts";
import { nameOf } from "./convention_names.ts";

export const groups = Object.keys(groupNames) as Group[];

/** The accent of a family: the two labels have one, the others none. */
export function accentOf(family: Family | undefined): "hamilton" | "jpl" | "custom" {
  if (family === "hamilton") return "hamilton";
  return family === "shuster" ? "jpl" : "custom";
}

export function libraryWith(engine: Engine, id: string | undefined): Library | undefined {
  return engine.libraries.find((library) => library.id === id);
}

/** Whether a record is of a library with quaternions, which has calls to be asked about. */
export const isLibrary = ({ kind, numbers }: Library) =>
  kind === undefined && numbers === undefined;

/** What an end is called. */
export function endName(end: Endpoint, engine: Engine): string {
  if (end.kind === "library") return libraryWith(engine, end.id)?.name ?? end.id;
  return nameOf(end.convention, engine) ?? customConvention;
}

/** The orders in which four numbers of a library stand, the usual one first: one, two, or none that is established. */
export function ordersOf(library: Library): ComponentOrder[] {
  const { printedOrder, arrayOrder, constructorOrder } = library;
  return [...new Set([printedOrder, arrayOrder, constructorOrder])].filter(
    (order) => order !== undefined,
  );
}

/** What is established of the way a library acts; nothing that the core assumed. */
export function establishedOf(described: LibraryDescription | undefined) {
  if (described === undefined || described.assumed.includes("action")) return {};
  const { action, family, firstToAct } = described;
  return { action, family, first: firstToAct };
}

/** `x y z w, Hamilton · 1.17.1, run`, `device, A B C in degrees · third parties, documented`. */
export function aboutLibrary(library: Library, engine: Engine): string {
  const { kind, numbers } = library;
  const { family } = establishedOf(engine.describeLibrary(library.id));
  const orders = ordersOf(library).map((order) => lettersOf[order]);
  const written = numbers ? numbersWords(numbers) : orders.join(" / ");
  const behaviour = [kind && kindNames[kind], written, family && familyWords[family][0]].filter(
    Boolean,
  );
  const known = `${library.version}, ${knownWords[library.known][0]}`;
  return behaviour.length === 0 ? known : `${behaviour.join(", ")} · ${known}`;
}
