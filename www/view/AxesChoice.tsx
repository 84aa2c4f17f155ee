// The optional step of a translation: new names for the axes of the world and of the body.
import { useEffect, useState } from "preact/hooks";
import { axisPresets, axisPresetWords } from "../axis_texts.ts";
import type { Store } from "../state.ts";
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
        Axes <span class="more-now">{summaryOf(worldAxes, bodyAxes)}</span>
      </summary>
      <div class="more-panel">
        <p>
          A step of its own, whatever the libraries: the same attitude between axes that point
          elsewhere. Say the new axes in terms of the old, as <code>y x -z</code>, or name two
          systems, as <code>NED to ENU</code>.
        </p>
        <div class="axes-sides">
          {sides.map(({ name, field, side, other, otherSide }) => (
            <fieldset key={name} class="axes-side" aria-label={`Axes of the ${side}`}>
              <div class="axes-side-head">
                <p class="axes-side-name">Axes of the {side}</p>
                <button
                  type="button"
                  class="quiet"
                  disabled={state[name] === state[other]}
                  onClick={() => store.set({ [other]: state[name] })}
                >
                  Same for the {otherSide}
                </button>
              </div>
              <TextField store={store} field={field} name={name} label={`axes of the ${side}`} />
              <select
                aria-label={`Named axes of the ${side}`}
                value={axisPresets.find((preset) => preset === state[name]) ?? ""}
                onChange={(event) => store.set({ [name]: event.currentTarget.value })}
              >
                <option value="">{state[name] === "" ? "stay as they are" : "none"}</option>
                {axisPresets.map((preset) => (
                  <option key={preset} value={preset}>
                    {preset}: {axisPresetWords[preset]}
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
            Leave all axes as they are
          </button>
        )}
      </div>
    </details>
  );
}

function summaryOf(world: string, body: string): string {
  if (world === "" && body === "") return "stay as they are";
  return `world ${world || "as it is"}, body ${body || "as it is"}`;
}
