// The optional step of a translation: new names for the axes of the world and of the body.
import { useEffect, useState } from "preact/hooks";
import { axisPresets } from "../axis_texts.ts";
import type { Store } from "../state.ts";
import { axesChoiceWords } from "../words/axes.tsx";
import { TextField } from "./Ask.tsx";

const sides = [
  { name: "worldAxes", field: "world-axes", side: "world", other: "bodyAxes", otherSide: "body" },
  { name: "bodyAxes", field: "body-axes", side: "body", other: "worldAxes", otherSide: "world" },
] as const;

export function AxesChoice({ store }: { store: Store }) {
  const state = store.state.value;
  const { worldAxes, bodyAxes } = state;
  const isSet = worldAxes !== "" || bodyAxes !== "";
  const [isOpen, setOpen] = useState(isSet);
  useEffect(() => {
    if (isSet) setOpen(true);
  }, [isSet]);
  return (
    <details class="more" open={isOpen} onToggle={(event) => setOpen(event.currentTarget.open)}>
      <summary>
        {axesChoiceWords.title}{" "}
        <span class="more-now">{axesChoiceWords.summary(worldAxes, bodyAxes)}</span>
      </summary>
      <div class="more-panel">
        <p>{axesChoiceWords.lead}</p>
        <div class="axes-sides">
          {sides.map(({ name, field, side, other, otherSide }) => (
            <fieldset key={name} class="axes-side" aria-label={axesChoiceWords.side[side]}>
              <div class="axes-side-head">
                <p class="axes-side-name">{axesChoiceWords.side[side]}</p>
                <button
                  type="button"
                  class="quiet"
                  disabled={state[name] === state[other]}
                  onClick={() => store.set({ [other]: state[name] })}
                >
                  {axesChoiceWords.sameFor[otherSide]}
                </button>
              </div>
              <TextField
                store={store}
                field={field}
                name={name}
                label={axesChoiceWords.field[side]}
              />
              <select
                aria-label={axesChoiceWords.named[side]}
                value={axisPresets.find((preset) => preset === state[name]) ?? ""}
                onChange={(event) => store.set({ [name]: event.currentTarget.value })}
              >
                <option value="">
                  {state[name] === "" ? axesChoiceWords.keep : axesChoiceWords.none}
                </option>
                {axisPresets.map((preset) => (
                  <option key={preset} value={preset}>
                    {axesChoiceWords.preset(preset)}
                  </option>
                ))}
              </select>
            </fieldset>
          ))}
        </div>
        {isSet && (
          <button
            type="button"
            class="quiet"
            onClick={() => store.set({ worldAxes: "", bodyAxes: "" })}
          >
            {axesChoiceWords.keepAll}
          </button>
        )}
      </div>
    </details>
  );
}
