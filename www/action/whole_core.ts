// The whole core, with the words for what it alone tells.
import { type Engine, loadWholeEngine } from "../engine.ts";
import { wholeWords } from "../words/parts/notes.tsx";

/** Loads both once; again only where that failed. */
export async function loadWhole(): Promise<Engine> {
  const [engine, words] = await Promise.all([
    loadWholeEngine(),
    import("../words/parts/whole_notes.tsx"),
  ]);
  wholeWords.there = words;
  return engine;
}
