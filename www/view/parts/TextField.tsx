// A field for text in any form, with the place of a problem marked in the text itself.
import type { ComponentChildren } from "preact";
import { useId } from "preact/hooks";
import { applyFirst, type TextName } from "../../action/fixes.ts";
import type { Field } from "../../engine.ts";
import type { Store } from "../../state/store.ts";
import { symbolOf } from "../../words/conventions.ts";
import * as words from "../../words/parts/ask.tsx";
import { MarkedText } from "./MarkedText.tsx";
import { stopIds } from "./Notes.tsx";
import "./text_field.css";

export const problemId = (field: Field) => `problem-${field}`;

/** The texts that a view is about. */
const heroes: readonly Field[] = ["quaternion", "p", "q"];

/** A field for text in any form, with the place of a problem marked in the text itself. */
export function TextField({
  store,
  field,
  name = field as TextName,
  label = field === "vector" ? words.vector : words.quaternion,
  children,
}: {
  store: Store;
  /** As the core names it in a problem. */
  field: Field;
  /** As the state names it. */
  name?: TextName;
  label?: string;
  /** What stands at its end. */
  children?: ComponentChildren;
}) {
  const id = useId();
  const text = store.state.value[name];
  const problem = store.problemOf(field);
  return (
    <div class={`field ${heroes.includes(field) ? "field-hero" : "field-plain"}`}>
      <div class="field-box" data-field={field}>
        <label for={id} class="field-label">
          <span class="visually-hidden">{label}</span>
          <var>{symbolOf[field]}</var>
        </label>
        <MarkedText
          id={id}
          name={name}
          text={text}
          problem={problem}
          describedBy={problem ? problemId(field) : stopIds(store, field).join(" ") || undefined}
          onInput={(typed) => store.set({ [name]: typed })}
          onAltEnter={() => applyFirst(store, field)}
        />
        {children}
      </div>
    </div>
  );
}
