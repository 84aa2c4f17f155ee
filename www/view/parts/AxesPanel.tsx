// The five axes of the declared convention, and how nine typed numbers are read.
import type { Convention, MatrixConvention } from "../../engine.ts";
import {
  type Axis,
  axes,
  declarationOf,
  declaredConvention,
  differing,
  operatorOf,
} from "../../model/conventions.ts";
import type { Store } from "../../state/store.ts";
import { namedConventions, namedConventionValues } from "../../values.ts";
import { conventionNames } from "../../words/conventions.ts";
import * as words from "../../words/parts/axes_panel.tsx";
import { AxisChoice } from "./AxisChoice.tsx";
import { MatrixOf } from "./RulesList.tsx";
import "./axes_panel.css";

export function AxesPanel({ store }: { store: Store }) {
  const state = store.state.value;
  const convention = declaredConvention(state);
  const base = namedConventions[state.preset];
  const setAxis = (axis: Axis, value: string) =>
    store.set({ axes: differing({ ...convention, [axis]: value } as Convention, base) });
  const { named } = store.engine.describe(convention);
  const form = state.view === "read" ? store.read.value?.report.paired.form : undefined;
  const setMatrix = (axis: keyof MatrixConvention, value: string) =>
    store.set({ matrix: { ...state.matrix, [axis]: value } as MatrixConvention });
  return (
    <div class="more-panel">
      <div class="named-conventions">
        <span id="named-conventions">{words.named}</span>
        <ul aria-labelledby="named-conventions">
          {namedConventionValues.map((name) => (
            <li key={name}>
              <button
                type="button"
                class="quiet"
                aria-pressed={name === named}
                onClick={() => store.set(declarationOf(name))}
              >
                {conventionNames[name]}
              </button>
            </li>
          ))}
        </ul>
      </div>
      <p>{words.five}</p>
      <div class="axis-choices">
        {axes.map((axis) => (
          <AxisChoice
            key={axis}
            axis={axis}
            group={axis}
            chosen={convention[axis]}
            choose={(value) => setAxis(axis, value)}
          />
        ))}
      </div>
      <p>
        {words.matrix(operatorOf(state.matrix))}
        {form && words.beside(<MatrixOf form={form} />)}
      </p>
      <div class="axis-choices">
        {(["function", "direction"] as const).map((axis) => (
          <AxisChoice
            key={axis}
            axis={axis}
            group={`matrix-${axis}`}
            of={words.ofMatrix}
            chosen={state.matrix[axis]}
            choose={(value) => setMatrix(axis, value)}
          />
        ))}
      </div>
    </div>
  );
}
