// The Read view: one quaternion, both conventions side by side.
import type { Digits, Preset } from "../address.ts";
import type { Column, ReadQuaternion, ReadReport } from "../engine.ts";
import { shown, shownArray } from "../format.ts";
import type { Store } from "../state.ts";
import { AskStatus, ConventionSwitch, DigitsSwitch, TextField } from "./Ask.tsx";
import { Facts } from "./Facts.tsx";
import { Notes } from "./Notes.tsx";
import { Relation } from "./Relation.tsx";
import { ArrayRow, ComponentStrip, Matrix, namesInOrder } from "./Value.tsx";

export function Read({ store }: { store: Store }) {
  const { quaternion, vector, digits, preset } = store.state.value;
  const shownResult = store.read.value;
  return (
    <>
      <section class="ask" aria-label="Input">
        <div class="ask-row">
          <TextField
            store={store}
            field="quaternion"
            symbol="q"
            label="quaternion"
            size="hero"
            text={quaternion}
            onText={(text) => store.set({ quaternion: text })}
          />
          <ConventionSwitch store={store} />
        </div>
        <div class="ask-row">
          <TextField
            store={store}
            field="vector"
            symbol="x"
            label="vector"
            size="plain"
            text={vector}
            onText={(text) => store.set({ vector: text })}
          />
          <Examples store={store} />
          <DigitsSwitch store={store} />
        </div>
        <AskStatus store={store} fields={fields}>
          {shownResult && <ReadAs report={shownResult.report} digits={digits} />}
        </AskStatus>
      </section>
      {shownResult && (
        <div class={`result ${shownResult.freshness}`}>
          <Result report={shownResult.report} digits={digits} preset={preset} />
        </div>
      )}
    </>
  );
}

const fields = [
  { field: "quaternion", symbol: "q" },
  { field: "vector", symbol: "x" },
] as const;

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
    name: "120° about (1,1,1)",
    quaternion: "1/2 + i/2 + j/2 + k/2",
    vector: "1 2 3",
    preset: "hamilton",
  },
];

function Examples({ store }: { store: Store }) {
  return (
    <div class="examples">
      <span id="examples-label">Examples</span>
      <ul aria-labelledby="examples-label">
        {examples.map(({ name, ...example }) => (
          <li key={name}>
            <button type="button" onClick={() => store.set(example)}>
              {name}
            </button>
          </li>
        ))}
      </ul>
    </div>
  );
}

function ReadAs({ report, digits }: { report: ReadReport; digits: Digits }) {
  return (
    <div class="read-as">
      <p>
        Read as <NamedComponents quaternion={report.quaternion} digits={digits} />
        {report.quaternion.norm !== undefined && (
          <span class="read-as-part">
            norm <code>{shown(report.quaternion.norm, digits)}</code>
          </span>
        )}
        <span class="read-as-part">
          <var>x</var> = <code>{shownArray(report.vector, digits)}</code>
        </span>
      </p>
      <Notes notes={report.notes} digits={digits} />
    </div>
  );
}

export function NamedComponents({
  quaternion,
  digits,
}: {
  quaternion: ReadQuaternion;
  digits: Digits;
}) {
  const { components, convention } = quaternion;
  return (
    <span class="named-components">
      {namesInOrder(convention).map((name) => (
        <span key={name} class="read-as-part">
          {name} <code>{shown(components[name], digits)}</code>
        </span>
      ))}
    </span>
  );
}

function Result({
  report,
  digits,
  preset,
}: {
  report: ReadReport;
  digits: Digits;
  preset: Preset;
}) {
  return (
    <>
      <div class="columns">
        <ConventionColumn
          preset="hamilton"
          declared={preset}
          column={report.hamilton}
          norm={report.quaternion.norm}
          digits={digits}
        />
        <ConventionColumn
          preset="jpl"
          declared={preset}
          column={report.jpl}
          norm={report.quaternion.norm}
          digits={digits}
        />
      </div>
      <Relation report={report} digits={digits} declared={preset} />
      <Facts report={report} digits={digits} />
    </>
  );
}

/** What the two presets are called and do; the same words everywhere on the page. */
export const wordsOf = {
  hamilton: {
    name: "Hamilton",
    matrix: "R",
    other: "C",
    product: "ij = k",
    order: "[w, x, y, z]",
    direction: "body → world",
    reversed: "world → body",
    effect: "Takes coordinates in the body frame to coordinates in the world frame.",
    vector: "x on the body axes, seen in the world",
  },
  jpl: {
    name: "JPL",
    matrix: "C",
    other: "R",
    product: "ij = −k",
    order: "[x, y, z, w]",
    direction: "world → body",
    reversed: "body → world",
    effect: "Takes coordinates in the world frame to coordinates in the body frame.",
    vector: "x on the world axes, seen in the body",
  },
} as const;

function ConventionColumn({
  preset,
  declared,
  column,
  norm,
  digits,
}: {
  preset: Preset;
  declared: Preset;
  column: Column;
  norm: number | undefined;
  digits: Digits;
}) {
  const words = wordsOf[preset];
  const matrix = (
    <>
      <var>{words.matrix}</var>(<var>q</var>)
    </>
  );
  const isUnit = column.unit.array.every((number, at) => number === column.quaternion.array[at]);
  return (
    <section class={`card column ${preset}`} aria-labelledby={`${preset}-name`}>
      <header>
        <h2 id={`${preset}-name`}>{words.name}</h2>
        {preset === declared && <span class="badge">as declared</span>}
        <p class="axes">
          <span>{words.product}</span> <span>{words.order}</span> <span>{words.direction}</span>
        </p>
        <p class="effect">{words.effect}</p>
      </header>
      <ComponentStrip
        symbol="q"
        components={column.quaternion}
        convention={column.convention}
        digits={digits}
      />
      <div class="matrices">
        <Matrix
          name={`${words.matrix}(q)`}
          symbol={matrix}
          caption={words.direction}
          rows={column.matrix}
          digits={digits}
        />
        <Matrix
          name={`inverse of ${words.matrix}(q)`}
          symbol={
            <>
              {matrix}
              <sup>−1</sup> = {matrix}
              <sup>T</sup>
            </>
          }
          caption={words.reversed}
          rows={column.inverseMatrix}
          digits={digits}
        />
      </div>
      <div class="rows">
        <ArrayRow
          name={`${words.matrix}(q) x`}
          symbol={
            <>
              {matrix} <var>x</var>
            </>
          }
          numbers={column.image}
          digits={digits}
          note={words.vector}
        />
        {!isUnit && (
          <>
            <ArrayRow
              name="unit quaternion"
              symbol={
                <>
                  <var>q</var>/|<var>q</var>|
                </>
              }
              numbers={column.unit.array}
              digits={digits}
              note={norm !== undefined && `norm 1, was ${shown(norm, digits)}`}
            />
            <ArrayRow
              name="conjugate"
              symbol={
                <>
                  <var>q</var>*
                </>
              }
              numbers={column.conjugate.array}
              digits={digits}
              note="the conjugate"
            />
          </>
        )}
        <ArrayRow
          name="inverse"
          symbol={
            <>
              <var>q</var>
              <sup>−1</sup>
              {isUnit && (
                <>
                  {" "}
                  = <var>q</var>*
                </>
              )}
            </>
          }
          numbers={column.inverse?.array}
          digits={digits}
          note={isUnit ? "the inverse, which is the conjugate" : "the inverse, conjugate / norm²"}
        />
      </div>
      <details class="products">
        <summary>Product matrices</summary>
        <div class="matrices">
          <Matrix
            name="left product matrix"
            symbol={
              <>
                <var>q</var>∘<var>p</var> = <var>L p</var>
              </>
            }
            caption={`on ${words.order}`}
            rows={column.leftProductMatrix}
            digits={digits}
          />
          <Matrix
            name="right product matrix"
            symbol={
              <>
                <var>p</var>∘<var>q</var> = <var>R p</var>
              </>
            }
            caption={`on ${words.order}`}
            rows={column.rightProductMatrix}
            digits={digits}
          />
        </div>
      </details>
    </section>
  );
}
