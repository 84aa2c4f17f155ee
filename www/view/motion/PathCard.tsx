// Where a rate leads in time, what goes wrong, and how well steps follow it.
import { pathValues } from "../../copy/motion_values.ts";
import type { MistakeKind, MotionReport, PathReport } from "../../engine.ts";
import { choicesOf, drawable, textOf } from "../../model/motion_choices.ts";
import { exactRows } from "../../number/format.ts";
import type { Store } from "../../state/store.ts";
import { mistakeWords } from "../../words/motion/mistakes.ts";
import * as words from "../../words/motion/motion.tsx";
import { Copy } from "../parts/Copy.tsx";
import { ArrayRow, ComponentStrip } from "../parts/Value.tsx";
import { ErrorPlot } from "./ErrorPlot.tsx";
import { Mistakes } from "./Mistakes.tsx";

const nothing = "";

/** How large an error is: `8.86e−2`. */
const rough = (error: number) => error.toExponential(2).replace("-", "−");

export function PathCard({
  store,
  path,
  report,
}: {
  store: Store;
  path: PathReport;
  report: MotionReport;
}) {
  const { digits } = store.state.value;
  const values = pathValues(path, report.quaternion.convention, store.engine.describe);
  const way = path.ways[0] ?? [];
  const { drawn } = choicesOf(store.state.value);
  return (
    <>
      <ComponentStrip
        symbol="q"
        name={words.endOf}
        components={path.end}
        value={values.end}
        convention={report.quaternion.convention}
        digits={digits}
      />
      <ArrayRow
        name={words.endTurn}
        symbol={words.endTurn}
        numbers={path.turn.rotationVectorRad}
        value={values.turn}
        digits={digits}
      />
      <div class="row">
        <span class="row-symbol">{words.wayName}</span>
        <span class="row-value">{words.moments(way.length)}</span>
        <Copy of={words.wayName} text={exactRows(way)} value={values.path} />
      </div>
      <Mistakes store={store} mistakes={path.mistakes} />
      <label class="motion-drawn">
        {words.drawnName}{" "}
        <select
          value={drawn ?? nothing}
          onChange={({ currentTarget: { value } }) => {
            const chosen = value === nothing ? undefined : (value as MistakeKind);
            store.set({ motion: textOf({ ...choicesOf(store.state.peek()), drawn: chosen }) });
          }}
        >
          {drawable.map((kind) => (
            <option key={kind} value={kind}>
              {mistakeWords[kind]}
            </option>
          ))}
          <option value={nothing}>{words.rightOnly}</option>
        </select>
      </label>
      <details class="fold">
        <summary>{words.stepsWrong}</summary>
        <Steps path={path} />
      </details>
    </>
  );
}

/** The errors at the asked number of steps, and over the length of the step. */
function Steps({ path }: { path: PathReport }) {
  const steps = (path.ways[0]?.length ?? 1) - 1;
  const orderOf = (rows: PathReport["integrators"][number]) =>
    rows.findLast(([, , , , order]) => order !== 0)?.[4];
  return (
    <div class="motion-compared">
      <ErrorPlot path={path} />
      <div class="motion-table">
        <table>
          <thead>
            <tr>
              {words.heads(steps).map((head) => (
                <th key={head} scope="col">
                  {head}
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {path.integrators.map((rows, at) => {
              const row = rows.find(([count]) => count === steps);
              const order = orderOf(rows);
              return (
                <tr key={words.kinds[at]}>
                  <th scope="row">
                    <i class={`series series-${at}`} aria-hidden="true" /> {words.kinds[at]}
                  </th>
                  <td>{row === undefined ? "–" : row[2] === 0 ? words.exact : rough(row[2])}</td>
                  <td>{order === undefined ? "–" : order.toFixed(2)}</td>
                  <td>{row === undefined || row[3] === 0 ? "–" : rough(row[3])}</td>
                </tr>
              );
            })}
          </tbody>
        </table>
      </div>
    </div>
  );
}
