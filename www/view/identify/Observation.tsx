// One observation: what to run, what went in, what was printed, and what that tells.
import type { ComponentChildren } from "preact";
import type { ObservationReport, Probe, Problem } from "../../engine.ts";
import { fieldOf, inputsOf, type TextName, textOf, withText } from "../../model/probes.ts";
import { matrixLayoutValues } from "../../values.ts";
import { symbolOf } from "../../words/conventions.ts";
import { layoutNames, probeWords } from "../../words/identify/choices.ts";
import * as words from "../../words/identify/observation.tsx";
import { Copy } from "../parts/Copy.tsx";
import { MarkedText } from "../parts/MarkedText.tsx";
import "../parts/ask.css";
import "../parts/result.css";
import "../parts/text_field.css";
import "./observation.css";

/** The field in which the answer to an observation is typed. */
export const printedId = (at: number) => `observation-${at}-printed`;

export function Observation({
  at,
  probe,
  report,
  code,
  isQuestion,
  lead,
  contradicts,
  button,
  onChange,
  onDone,
}: {
  /** Its place in the list, from 0. */
  at: number;
  probe: Probe;
  /** Absent for a question that is not answered yet. */
  report: ObservationReport | undefined;
  code: string | undefined;
  isQuestion: boolean;
  /** What is said before it is asked. */
  lead?: string | undefined;
  /** The places of those that it contradicts. */
  contradicts: readonly number[];
  /** What takes it away. */
  button: ComponentChildren;
  onChange: (probe: Probe) => void;
  /** The answer is complete. */
  onDone: () => void;
}) {
  const { name, asks } = probeWords[probe.probe];
  const id = `observation-${at}`;
  const problem = report?.status === "problem" ? report.problem : undefined;
  const isFalse = contradicts.length > 0;
  const field = (text: TextName) => (
    <Text
      key={text}
      id={`${id}-${text}`}
      of={words.of(at)}
      name={text}
      text={textOf(probe, text)}
      problem={problem?.field === fieldOf[text] ? problem : undefined}
      isWrong={text === "printed" && (isFalse || report?.status === "unexplained")}
      describedBy={`${id}-told`}
      onInput={(typed) => onChange(withText(probe, text, typed))}
      onDone={report?.status === "told" ? onDone : undefined}
    />
  );
  return (
    <li
      class={`observation ${isQuestion ? "question" : ""} ${isFalse ? "contradicting" : ""}`}
      aria-labelledby={`${id}-name`}
    >
      <header>
        <span class="observation-number" aria-hidden="true">
          {at + 1}
        </span>
        <h3 id={`${id}-name`}>
          <span class="visually-hidden">
            {isQuestion ? words.question(at) : words.observation(at)}
          </span>
          {name}
        </h3>
        {isFalse && <span class="badge">{words.contradicts(contradicts)}</span>}
        {button}
      </header>
      <p class="observation-asks">{asks}</p>
      {code !== undefined && (
        <div class="probe-code">
          <pre>
            <code>{code}</code>
          </pre>
          <Copy of={words.code(at)} text={code} />
        </div>
      )}
      <div class={`observation-texts probe-${probe.probe}`}>
        {inputsOf[probe.probe].map(field)}
        {field("printed")}
        {(probe.probe === "matrix" || probe.probe === "from-matrix") && (
          <Layout probe={probe} at={at} onChange={onChange} />
        )}
      </div>
      <div class="told" id={`${id}-told`}>
        <Told report={report} before={lead} />
      </div>
    </li>
  );
}

/** A text of an observation, with the place of a problem marked in it. */
function Text({
  id,
  of,
  name,
  text,
  problem,
  isWrong,
  describedBy,
  onInput,
  onDone,
}: {
  id: string;
  of: string;
  name: TextName;
  text: string;
  problem: Problem | undefined;
  isWrong: boolean;
  describedBy: string;
  onInput: (text: string) => void;
  /** What the Enter key does; it starts a new line where this is absent. */
  onDone: (() => void) | undefined;
}) {
  const symbol = symbolOf[fieldOf[name]];
  return (
    <div class={`field field-${name === "printed" ? "printed" : "input"}`}>
      <div class="field-box">
        <label for={id} class="field-label">
          <span class="visually-hidden">{of} </span>
          {name === "printed" ? symbol : <var>{symbol}</var>}
        </label>
        <MarkedText
          id={id}
          text={text}
          problem={problem}
          isWrong={problem !== undefined || isWrong}
          describedBy={describedBy}
          onInput={onInput}
          onEnter={onDone}
        />
      </div>
    </div>
  );
}

/** How nine numbers run. */
function Layout({
  probe,
  at,
  onChange,
}: {
  probe: Probe & { probe: "matrix" | "from-matrix" };
  at: number;
  onChange: (probe: Probe) => void;
}) {
  return (
    <label class="layout">
      <span class="visually-hidden">{words.of(at)} </span>
      {words.layout}{" "}
      <select
        value={probe.layout ?? "as-written"}
        onChange={(event) => {
          const layout = matrixLayoutValues.find((name) => name === event.currentTarget.value);
          if (layout) onChange({ ...probe, layout });
        }}
      >
        {matrixLayoutValues.map((layout) => (
          <option key={layout} value={layout}>
            {layoutNames[layout]}
          </option>
        ))}
      </select>
    </label>
  );
}

/** Farther from every behaviour than this, numbers were rounded. */
const rounded = 1e-6;

/** What an observation tells, or why it tells nothing. */
function Told({
  report,
  before = words.empty,
}: {
  report: ObservationReport | undefined;
  before?: string | undefined;
}) {
  switch (report?.status) {
    case undefined:
    case "empty":
      return <p>{before}</p>;
    case "problem":
      return <p class="problem">{words.problemOf(report.problem)}</p>;
    case "unexplained": {
      const off = report.distance === undefined ? undefined : percent(report.distance);
      return <p class="problem">{words.unexplained(off)}</p>;
    }
    case "told":
      return (
        <p>
          {words.told(report.settles, report.possible)}
          {report.distance > rounded && words.rounded(percent(report.distance))}
        </p>
      );
  }
}

/** `0.05 %`, two digits. */
function percent(part: number): string {
  return `${Number((100 * part).toPrecision(2))} %`;
}
