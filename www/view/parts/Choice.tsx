// One of a few values, of which all are seen: radio buttons under a legend.
import type { ComponentChildren } from "preact";
import { useId } from "preact/hooks";
import "./choice.css";

export interface ValueInWords<Value extends string> {
  value: Value;
  words: ComponentChildren;
  /** In full, where the words are short. */
  name?: string;
}

export function Choice<Value extends string>({
  kind,
  group,
  legend,
  values,
  chosen,
  choose,
}: {
  /** How it looks: short words in a line, an axis with what its values do, or boxes with notes. */
  kind: "choice" | "axis" | "segments";
  /** Names the radio buttons that belong together: one of its own on the page. */
  group: string;
  legend: ComponentChildren;
  values: readonly ValueInWords<Value>[];
  chosen: Value;
  choose: (value: Value) => void;
}) {
  const id = useId();
  return (
    // No fieldset: WebKit puts the legend of one above all that stands in a line.
    <div class={kind} role="radiogroup" aria-labelledby={id}>
      <span class="legend" id={id}>
        {legend}
      </span>
      {values.map(({ value, words, name }) => (
        <label key={value}>
          <input
            type="radio"
            name={group}
            value={value}
            aria-label={name}
            checked={value === chosen}
            onChange={() => choose(value)}
          />
          {words}
        </label>
      ))}
    </div>
  );
}
