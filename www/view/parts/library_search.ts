// Finding a record by what people type; pure.
import type { Library } from "../../engine.ts";
import { groupNames, languageNames, numbersNames } from "../../words/library_behaviour.ts";

const wordsOf = (text: string) => text.toLowerCase().split(/[\s,;/]+/);

/** How well a record fits a text: the smaller the better, undefined where it does not. */
function distance(library: Library, asked: ReadonlySet<string>, about: string): number | undefined {
  const name = library.name.toLowerCase();
  const others = [library.id, ...(library.words ?? [])].join(" ").toLowerCase();
  const { group, language, axes, numbers } = library;
  const written = numbers && numbersNames[numbers.kind];
  const field = [groupNames[group], group, languageNames[language], axes, written, about]
    .join(" ")
    .toLowerCase();
  let farthest = 0;
  for (const word of asked) {
    const distance = distanceOf(word, { id: library.id, name, others, field });
    if (distance === undefined) return undefined;
    farthest = Math.max(farthest, distance);
  }
  return farthest;
}

function distanceOf(
  word: string,
  { id, name, others, field }: { id: string; name: string; others: string; field: string },
): number | undefined {
  if (name.startsWith(word) || id.startsWith(word)) return 0;
  if (wordsOf(name).some((part) => part.startsWith(word))) return 1;
  if (name.includes(word)) return 2;
  if (others.includes(word)) return 3;
  // `xyzw` is found as the letters x y z w.
  return field.includes(word) || field.replaceAll(" ", "").includes(word) ? 4 : undefined;
}

/** The records that fit every word of a text, the best first; all in their order for none. */
export function found(
  libraries: readonly Library[],
  asked: string,
  about: (library: Library) => string,
): Library[] {
  // Each word once: a text may be of any length.
  const words = new Set(wordsOf(asked));
  return libraries
    .map((library) => ({ library, distance: distance(library, words, about(library)) }))
    .filter(({ distance }) => distance !== undefined)
    .sort((one, other) => (one.distance ?? 0) - (other.distance ?? 0))
    .map(({ library }) => library);
}
