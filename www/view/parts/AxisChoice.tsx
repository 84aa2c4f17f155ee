// The two values of one axis, each with what it does.
import { type Axis, axisValues } from "../../model/conventions.ts";
import { axisWords } from "../../words/conventions.ts";
import { Choice } from "./Choice.tsx";
import { valueWords } from "./convention_names.ts";

export function AxisChoice({
  axis,
  group,
  of,
  chosen,
  choose,
}: {
  axis: Axis;
  group: string;
  of?: string;
  chosen: string;
  choose: (value: string) => void;
}) {
  const { name, asks } = axisWords[axis];
  return (
    <Choice
      kind="axis"
      group={group}
      legend={
        <>
          {name} {of} <span class="axis-asks">{asks}</span>
        </>
      }
      values={axisValues[axis].map((value) => {
        const [word, effect] = valueWords(axis, value);
        return {
          value,
          words: (
            <>
              <span class="axis-word">{word}</span> <span class="axis-effect">{effect}</span>
            </>
          ),
        };
      })}
      chosen={chosen}
      choose={choose}
    />
  );
}
