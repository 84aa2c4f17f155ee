// The optional step of a translation: new names for the axes of the world and of the body.
import { useEffect, useState } from "preact/hooks";
import { axisPresets } from "../../model/axis_mapping.ts";
import type { Store } from "../../state/store.ts";
import * as words from "../../words/translate/axes_choice.tsx";
import { TextField } from "../parts/TextField.tsx";
import "../parts/axes_panel.css";
import "./axes_choice.css";

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
        {words.title} <span class="more-now">{words.summary(worldAxes, bodyAxes)}</span>
      </summary>
      <div class="more-panel">
        <p>{words.lead}</p>
        <div class="axes-sides">
          {sides.map(({ name, field, side, other, otherSide }) => (
            <fieldset key={name} class="axes-side" aria-label={words.side[side]}>
              <div class="axes-side-head">
                <p class="axes-side-name">{words.side[side]}</p>
                <button
                  type="button"
                  class="quiet"
                  disabled={state[name] === state[other]}
                  onClick={() => store.set({ [other]: state[name] })}
                >
                  {words.sameFor[otherSide]}
                </button>
              </div>
              <TextField store={store} field={field} name={name} label={words.field[side]} />
              <select
                aria-label={words.named[side]}
                value={axisPresets.find((preset) => preset === state[name]) ?? ""}
                onChange={(event) => store.set({ [name]: event.currentTarget.value })}
              >
                <option value="">{state[name] === "" ? words.keep : words.none}</option>
                {axisPresets.map((preset) => (
                  <option key={preset} value={preset}>
                    {words.preset(preset)}
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
            {words.keepAll}
          </button>
        )}
      </div>
    </details>
  );
}
