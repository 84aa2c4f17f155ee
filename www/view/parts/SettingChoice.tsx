// A setting: one of a few words.
import type { ComponentChildren } from "preact";
import { Choice } from "./Choice.tsx";

export function SettingChoice<Value extends string>({
  name,
  label,
  choices,
  chosen,
  words,
  names = words,
  onChoose,
}: {
  name: string;
  label: ComponentChildren;
  choices: readonly Value[];
  chosen: Value;
  words: Record<Value, string>;
  /** In full, where the words are short. */
  names?: Record<Value, string>;
  onChoose: (value: Value) => void;
}) {
  return (
    <Choice
      kind="choice"
      group={name}
      legend={label}
      values={choices.map((value) => ({
        value,
        words: <span>{words[value]}</span>,
        name: names[value],
      }))}
      chosen={chosen}
      choose={onChoose}
    />
  );
}
