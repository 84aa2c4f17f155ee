// *More*: a line that says which convention is declared; the axes in it come after the first result.
import { declaredConvention } from "../../model/conventions.ts";
import type { Store } from "../../state/store.ts";
import { wordsOf } from "../../words/conventions.ts";
import * as askWords from "../../words/parts/ask.tsx";
import { waits } from "../../words/parts/later.ts";
import * as words from "../../words/parts/more_axes.ts";
import { presetItself } from "./convention_names.ts";
import { useLater } from "./later.ts";
import "./fold.css";
import "./more_axes.css";

const loadPanel = () => import("./AxesPanel.tsx").then(({ AxesPanel }) => AxesPanel);

export function MoreAxes({ store }: { store: Store }) {
  const Panel = useLater(loadPanel);
  const preset = presetItself(declaredConvention(store.state.value), store.engine);
  // In full it stands on the switch.
  const name = preset ? wordsOf[preset].name : askWords.custom;
  return (
    <details class="more">
      <summary>
        {words.more}
        <span class="convention-now">
          {": "}
          <span>{name}</span> {words.choices}
        </span>
      </summary>
      {typeof Panel === "string" ? (
        <p class="fold-wait">{waits[Panel]}</p>
      ) : (
        <Panel store={store} />
      )}
    </details>
  );
}
