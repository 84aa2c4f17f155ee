// The choices of the Identify view in words.
import type { BehaviourAxis, Language } from "../../engine.ts";
import { choiceWords } from "../../words/identify/choices.ts";
import { languageNames } from "../../words/library_behaviour.ts";

/** Languages of code lines; a message has none of its own. */
export const codeLanguages = (Object.keys(languageNames) as Language[]).filter(
  (language) => language !== "message",
);

/** A value in words. */
export function wordsOfValue(choice: BehaviourAxis, value: string): string {
  const words: Record<string, string> = choiceWords[choice].values;
  return words[value] ?? value;
}
