// The Frames view: named frames, what is known between them, and where one stands in another.
import { useRef } from "preact/hooks";
import { columnValues, eulerValue, matrixValue } from "../../copy/values.ts";
import type { FoundPose, FramesReport } from "../../engine.ts";
import {
  exactArray,
  fromDegrees,
  shown,
  shownAngle,
  shownArray,
  shownAxis,
  shownRoughAngle,
} from "../../number/format.ts";
import type { Store } from "../../state/store.ts";
import * as words from "../../words/frames/frames.tsx";
import { ConventionSwitch } from "../parts/ConventionSwitch.tsx";
import { Copy } from "../parts/Copy.tsx";
import { NumberSettings } from "../parts/NumberSettings.tsx";
import { Picture } from "../parts/Picture.tsx";
import { UndoRedo } from "../parts/UndoRedo.tsx";
import { ArrayRow, ComponentStrip, Matrix } from "../parts/Value.tsx";
import { changing, Problems, Question, Rows } from "./Rows.tsx";
import { rigOf } from "./rows.ts";
import "../parts/ask.css";
import "../parts/fold.css";
import "../parts/result.css";
import "../parts/text_field.css";
import "./frames.css";

export { askedOfFrames } from "./asked.ts";

export function Frames({ store }: { store: Store }) {
  const report = store.frames.value?.report;
  // While the question or a row has a problem the last answer stays, grey.
  const answered = useRef<FramesReport>(undefined);
  if (report?.answer) answered.current = report;
  const last = answered.current;
  const rig = rigOf(store.state.value.frames);
  const change = changing(store);
  return (
    <>
      <section class="ask frames-ask" aria-label={words.input}>
        <div class="ask-row">
          <Question rig={rig} report={report} change={change} />
          <ConventionSwitch store={store} />
        </div>
        <Problems rig={rig} report={report} change={change} />
        <div class="ask-line">
          <NumberSettings store={store} />
          <UndoRedo store={store} />
        </div>
      </section>
      <div class="frames-result result current">
        <div class="frames-side">
          {last?.answer ? (
            <div class={`result ${report === last ? "current" : "old"}`}>
              <Answer store={store} report={last} answer={last.answer} />
            </div>
          ) : (
            <p class="card frames-none">{words.noAnswer}</p>
          )}
          {report && <Loops store={store} report={report} />}
        </div>
        <Picture store={store} of="frames" />
      </div>
      <Rows store={store} rig={rig} report={report} change={change} />
    </>
  );
}

const nameOf = (report: FramesReport, at: number | undefined) => report.frames[at ?? 0]?.name ?? "";

const titleOf = (report: FramesReport) =>
  words.title(nameOf(report, report.path.at(-1)?.frame), nameOf(report, 0));

function turnOf({ turn }: FoundPose, store: Store): string {
  const { unit } = store.state.value;
  const { axis, angleDeg } = turn;
  return axis ? words.turn(shownRoughAngle(angleDeg, unit, 4), shownAxis(axis, "4")) : words.noTurn;
}

function Answer({
  store,
  report,
  answer,
}: {
  store: Store;
  report: FramesReport;
  answer: FoundPose;
}) {
  const { digits, unit } = store.state.value;
  const { describe } = store.engine;
  const { hamilton, jpl, position, homogeneous, inverseHomogeneous, euler } = answer;
  const child = nameOf(report, report.path.at(-1)?.frame);
  const parent = nameOf(report, 0);
  const angles = euler.anglesDeg.map((angle) => shownAngle(fromDegrees(angle), digits, unit));
  const points = report.frames.filter(({ point }) => point !== undefined);
  const { misprintedPosition, misprintedDistance = 0 } = answer;
  return (
    <section class="card frames-answer" aria-labelledby="frames-answer">
      <h2 id="frames-answer">{titleOf(report)}</h2>
      {position ? (
        <ArrayRow
          name={words.position}
          symbol={<var>p</var>}
          numbers={position}
          digits={digits}
          value={{ kind: "vector", symbol: "p", numbers: position, on: words.copies.position }}
        />
      ) : (
        <p>{words.noPosition}</p>
      )}
      <p>{turnOf(answer, store)}</p>
      {([hamilton, jpl] as const).map((column) => {
        const name = column === hamilton ? "Hamilton" : "JPL";
        return (
          <div key={name} class={column === hamilton ? "hamilton" : "jpl"}>
            <ComponentStrip
              symbol={name}
              name={words.quaternionOf(name)}
              components={column.unit}
              convention={column.convention}
              value={columnValues(column, describe).unit}
              digits={digits}
            />
          </div>
        );
      })}
      <Way report={report} />
      {points.length > 0 && (
        <>
          <h3>{words.pointsName}</h3>
          {points.map(({ name, point }) => (
            <ArrayRow
              key={name}
              name={`${words.point}: ${name}`}
              symbol={name}
              numbers={point}
              digits={digits}
              value={
                point && { kind: "vector", symbol: "x", numbers: point, on: words.copies.point }
              }
            />
          ))}
        </>
      )}
      {misprintedPosition && misprintedDistance > 0 && (
        <>
          <h3>{words.mistakeName}</h3>
          <p class="frames-mistake">
            {words.mistake} <code>{shownArray(misprintedPosition, digits)}</code>{" "}
            <Copy of={words.misprinted} text={exactArray(misprintedPosition)} />
            {words.off(shown(misprintedDistance, digits))}
          </p>
        </>
      )}
      <details class="fold">
        <summary>{words.more}</summary>
        <div class="frames-more">
          <ArrayRow
            name={words.euler}
            symbol={words.euler}
            numbers={euler.anglesDeg}
            digits={digits}
            note={angles.join(", ")}
            value={eulerValue(euler)}
          />
          {homogeneous ? (
            <>
              <Matrix
                name={`${words.homogeneous} ${words.takes(child, parent)}`}
                symbol={words.takes(child, parent)}
                rows={homogeneous}
                digits={digits}
                value={matrixValue("T", homogeneous, words.copies.homogeneous)}
              />
              {inverseHomogeneous && (
                <Matrix
                  name={`${words.homogeneous} ${words.takes(parent, child)}`}
                  symbol={words.takes(parent, child)}
                  rows={inverseHomogeneous}
                  digits={digits}
                  value={matrixValue("T^-1", inverseHomogeneous, words.copies.inverse)}
                />
              )}
            </>
          ) : (
            <Matrix
              name={words.takes(child, parent)}
              symbol={words.takes(child, parent)}
              rows={hamilton.matrix}
              digits={digits}
              value={columnValues(hamilton, describe).matrix}
            />
          )}
        </div>
      </details>
    </section>
  );
}

/** The steps, and the product of each notation along them. */
function Way({ report }: { report: FramesReport }) {
  const { path } = report;
  const factors = path.map(({ pose, inverted, frame }, at) => {
    const before = nameOf(report, at === 0 ? 0 : path[at - 1]?.frame);
    const after = nameOf(report, frame);
    const [parent, child] = inverted ? [after, before] : [before, after];
    return { pose, inverted, after, parent, child };
  });
  const all = `${nameOf(report, 0)} ${nameOf(report, path.at(-1)?.frame)}`;
  const product = (sign: string, inOrder: typeof factors) => (
    <p class="frames-product">
      <var>q</var>
      <sub>{all}</sub> ={" "}
      {inOrder.map(({ parent, child, inverted, pose }, at) => (
        <span key={pose}>
          {at > 0 && ` ${sign} `}
          <var>q</var>
          <sub>
            {parent} {child}
          </sub>
          {inverted && "*"}
        </span>
      ))}
    </p>
  );
  return (
    <>
      <h3>{words.wayName}</h3>
      <p class="frames-way">
        {nameOf(report, 0)}
        {factors.map(({ after, inverted, pose }) => (
          <span key={pose}>
            {" → "}
            {after} <small>({inverted ? words.inverted(pose) : words.row(pose)})</small>
          </span>
        ))}
      </p>
      {product("⊙", factors)}
      <p class="frames-order">{words.orderIs.hamilton}</p>
      {product("⊗", [...factors].reverse())}
      <p class="frames-order">{words.orderIs.jpl}</p>
    </>
  );
}

/** Nearer than this a loop closes as well as numbers with six decimals can. */
const closeDeg = 1e-4;
const closeDistance = 1e-5;

function Loops({ store, report }: { store: Store; report: FramesReport }) {
  const { digits, unit } = store.state.value;
  if (report.loops.length === 0) return null;
  return (
    <section class="card frames-loops" aria-labelledby="frames-loops">
      <h2 id="frames-loops">{words.closesName}</h2>
      <ul>
        {report.loops.map(
          ({ pose, frames, angleDeg, distance, inverseCloses, transposeCloses }) => {
            const way = frames.map((at) => nameOf(report, at)).join(" → ");
            const isClosed = angleDeg < closeDeg && (distance ?? 0) < closeDistance;
            const off = distance === undefined ? undefined : shown(distance, digits);
            return (
              <li key={pose} class={isClosed ? undefined : "frames-open"}>
                {isClosed
                  ? words.agrees(pose, way)
                  : words.loop(pose, shownRoughAngle(angleDeg, unit, 4), off, way)}
                {!isClosed &&
                  inverseCloses !== undefined &&
                  ` ${words.inverseCloses(inverseCloses)}`}
                {!isClosed &&
                  inverseCloses === undefined &&
                  transposeCloses !== undefined &&
                  ` ${words.transposeCloses(transposeCloses)}`}
              </li>
            );
          },
        )}
      </ul>
    </section>
  );
}

/** What a screen reader hears when the result changes. */
export function spokenPose(store: Store): string {
  const report = store.frames.value?.report;
  if (report?.answer === undefined) return words.noAnswer;
  const { position } = report.answer;
  const at = position ? words.spokenPosition(shownArray(position, store.state.value.digits)) : "";
  return words.spoken(titleOf(report), turnOf(report.answer, store), at);
}
