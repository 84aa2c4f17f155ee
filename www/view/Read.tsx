// The Read view: one attitude, both conventions side by side.
import { type Preset, toFragment } from "../address.ts";
import type { ReadReport } from "../engine.ts";
import { shown, shownArray } from "../format.ts";
import type { Store } from "../state.ts";
import { AskRest, ConventionSwitch, TextField } from "./Ask.tsx";
import { ConventionColumn } from "./Column.tsx";
import { DeclaredCard } from "./Declared.tsx";
import { Facts } from "./Facts.tsx";
import { NamedComponents } from "./Form.tsx";
import { Notes } from "./Notes.tsx";
import { Relation } from "./Relation.tsx";
import { presetLike } from "./words.ts";

export function Read({ store }: { store: Store }) {
  const shownResult = store.read.value;
  return (
    <>
      <section class="ask" aria-label="Input">
        <div class="ask-row">
          <TextField store={store} field="quaternion" />
          <ConventionSwitch store={store} />
        </div>
        <AskRest
          store={store}
          freshness={shownResult?.freshness}
          examples={<Examples store={store} />}
        >
          {shownResult && <ReadAs report={shownResult.report} store={store} />}
        </AskRest>
      </section>
      {shownResult && (
        <div class={`result ${shownResult.freshness}`}>
          <Result report={shownResult.report} store={store} />
        </div>
      )}
    </>
  );
}

/** What there is to type, one example of each description. */
const examples: { name: string; quaternion: string; vector: string; preset: Preset }[] = [
  {
    name: "45° about z",
    quaternion: "cos(pi/8) + sin(pi/8) k",
    vector: "1/√2, 1/√2, 0",
    preset: "hamilton",
  },
  {
    name: "A JPL filter log",
    quaternion: "-0.0212 0.7031 0.0148 0.7106",
    vector: "0 0 -9.81",
    preset: "jpl",
  },
  {
    name: "A ROS message",
    quaternion: "x: 0.0\ny: 0.0\nz: 0.7071\nw: 0.7071",
    vector: "1 0 0",
    preset: "hamilton",
  },
  {
    name: "Yaw, pitch, roll",
    quaternion: "ZYX 30° 20° 10°",
    vector: "1 0 0",
    preset: "hamilton",
  },
  {
    name: "A matrix",
    quaternion: "0.36 -0.48 0.8\n0.8 0.6 0\n-0.48 0.64 0.6",
    vector: "1 0 0",
    preset: "hamilton",
  },
  {
    name: "Axis and angle",
    quaternion: "90° about [0, 1, 1]",
    vector: "1 0 0",
    preset: "hamilton",
  },
  {
    name: "120° about (1,1,1)",
    quaternion: "1/2 + i/2 + j/2 + k/2",
    vector: "1 2 3",
    preset: "hamilton",
  },
];

/** Links, so that going back returns to what was typed before. */
function Examples({ store }: { store: Store }) {
  return (
    <div class="examples">
      <span id="examples-label">Examples</span>
      <ul aria-labelledby="examples-label">
        {examples.map(({ name, ...example }) => (
          <li key={name}>
            <a href={`#${toFragment({ ...store.state.value, ...example, axes: {} })}`}>{name}</a>
          </li>
        ))}
      </ul>
    </div>
  );
}

function ReadAs({ report, store }: { report: ReadReport; store: Store }) {
  const { digits } = store.state.value;
  return (
    <div class="read-as">
      <p>
        Read as <NamedComponents quaternion={report.quaternion} digits={digits} />
        {report.quaternion.form.kind === "quaternion" && report.quaternion.norm !== undefined && (
          <span class="read-as-part">
            norm <code>{shown(report.quaternion.norm, digits)}</code>
          </span>
        )}
        <span class="read-as-part">
          <var>x</var> = <code>{shownArray(report.vector, digits)}</code>
        </span>
      </p>
      <Notes notes={report.notes} store={store} />
    </div>
  );
}

function Result({ report, store }: { report: ReadReport; store: Store }) {
  const { digits } = store.state.value;
  // What the numbers were declared as, which is not the switch's state while a text has a problem.
  const declared = presetLike(report.quaternion.convention, store.engine);
  return (
    <>
      {declared === undefined && (
        <DeclaredCard report={report} engine={store.engine} digits={digits} />
      )}
      <div class="columns">
        {(["hamilton", "jpl"] as const).map((preset) => (
          <ConventionColumn
            key={preset}
            preset={preset}
            declared={declared}
            column={report[preset]}
            digits={digits}
          />
        ))}
      </div>
      <Relation report={report} digits={digits} declared={declared} />
      <Facts report={report} store={store} />
    </>
  );
}
