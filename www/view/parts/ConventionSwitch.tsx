// Declares how the text is meant: as a preset, or as the convention that is chosen beyond both.
import { declaredConvention } from "../../model/conventions.ts";
import { presetChoices } from "../../model/page_state.ts";
import type { Store } from "../../state/store.ts";
import { wordsOf } from "../../words/conventions.ts";
import * as words from "../../words/parts/ask.tsx";
import { fiveWords, nameOf } from "./convention_names.ts";
import "./convention_switch.css";

/** Declares how the text is meant. */
export function ConventionSwitch({ store }: { store: Store }) {
  const state = store.state.value;
  const convention = declaredConvention(state);
  const isPreset = Object.keys(state.axes).length === 0;
  const chosen = isPreset ? state.preset : undefined;
  return (
    <fieldset class="switch">
      <legend class="visually-hidden">{words.meantAs}</legend>
      {presetChoices.map((preset) => (
        <label key={preset} class={`switch-choice ${preset}`}>
          <input
            type="radio"
            name="convention"
            value={preset}
            checked={preset === chosen}
            onChange={() => store.set({ preset, axes: {} })}
          />
          <span class="switch-name">{wordsOf[preset].name}</span>
          <span class="switch-meaning">{wordsOf[preset].meaning}</span>
        </label>
      ))}
      {!isPreset && (
        <label class="switch-choice custom">
          <input type="radio" name="convention" value="custom" checked />
          <span class="switch-name">{words.custom}</span>
          <span class="switch-meaning">
            {nameOf(convention, store.engine) ?? fiveWords(convention)}
          </span>
        </label>
      )}
    </fieldset>
  );
}
