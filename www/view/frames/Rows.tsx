// What is known between frames, a row a pose, and the question.
import type { Field, FramesReport, Note, Problem, Suggestion } from "../../engine.ts";
import { shownArray } from "../../number/format.ts";
import { announce } from "../../state/announcement.ts";
import type { Store } from "../../state/store.ts";
import * as words from "../../words/frames/frames.tsx";
import { doneWords, fixWords, noteWords, wholeWords } from "../../words/parts/notes.tsx";
import { MarkedText } from "../parts/MarkedText.tsx";
import "../parts/notes.css";
import {
  emptyRow,
  examples,
  mostRows,
  type Rig,
  type Row,
  rigOf,
  rigToText,
  rowConventions,
} from "./rows.ts";

/** Changes what is asked. */
export type Change = (part: Partial<Rig>) => void;

export function changing(store: Store): Change {
  return (part) =>
    store.set({ frames: rigToText({ ...rigOf(store.state.peek().frames), ...part }) });
}

interface AskedProps {
  rig: Rig;
  report: FramesReport | undefined;
  change: Change;
}

export function Question({ rig, report, change }: AskedProps) {
  const problems = report?.problems ?? [];
  const problemOf = (field: Problem["field"]) =>
    problems.find((problem) => problem.field === field);
  const name = (field: "child" | "parent", label: string) => (
    <input
      id={`frames-${field}`}
      class="frame-name"
      aria-label={label}
      aria-invalid={problemOf(field) !== undefined}
      aria-describedby="frames-problems"
      autocomplete="off"
      autocapitalize="off"
      spellcheck={false}
      value={rig[field]}
      onInput={(event) => change({ [field]: event.currentTarget.value })}
    />
  );
  return (
    <div class="frames-question">
      <span>{words.question}</span> {name("child", words.askedChild)} <span>{words.inWord}</span>{" "}
      {name("parent", words.askedParent)}
      <span aria-hidden="true">?</span>
      <label class="frames-point">
        {words.pointIn(rig.child)}{" "}
        <input
          class="frame-point"
          aria-invalid={problemOf("point") !== undefined}
          aria-describedby="frames-problems"
          placeholder="x y z"
          autocomplete="off"
          spellcheck={false}
          value={rig.point}
          onInput={(event) => change({ point: event.currentTarget.value })}
        />
      </label>
    </div>
  );
}

/** What is wrong with the question. */
export function Problems({ rig, report, change }: AskedProps) {
  const problemsOfQuestion = report !== undefined && report.problems.length > 0;
  const unread = (report?.poses ?? []).flatMap(({ problems }, at) =>
    problems.length > 0 ? [at + 1] : [],
  );
  return (
    <div id="frames-problems">
      {problemsOfQuestion && unread.length > 0 && (
        <p class="frames-problem">{words.unreadRows(unread)}</p>
      )}
      {report?.problems.map((problem) => (
        <ProblemLine key={problem.field} problem={problem} rig={rig} change={change} />
      ))}
    </div>
  );
}

/** A problem with the buttons that mend it. */
function ProblemLine({ problem, rig, change }: { problem: Problem; rig: Rig; change: Change }) {
  const { field, suggestion, choices } = problem;
  const renamed = (old: string, name: string) => {
    const of = (text: string) => (text.trim() === old ? name : text);
    return rig.rows.map((row) => ({ ...row, child: of(row.child), parent: of(row.parent) }));
  };
  const mend = ({ remedy, text, label = "" }: Suggestion) => {
    if (remedy === "add-pose")
      change({ rows: [...rig.rows, { ...emptyRow, child: text, parent: label }] });
    else if (label !== "") change({ rows: renamed(label, text) });
    else change({ [field]: text });
  };
  const wordsOf = ({ remedy, text, label = "" }: Suggestion) =>
    remedy === "add-pose" ? words.fixWords.add(text, label) : words.fixWords.rename(text, label);
  const fixes = [...(suggestion ? [suggestion] : []), ...choices].filter(
    ({ remedy }) => remedy !== "add-pose" || rig.rows.length < mostRows,
  );
  return (
    <p class="frames-problem">
      {words.problemOf(problem)}
      {fixes.map((fix) => (
        <button key={wordsOf(fix)} type="button" class="quiet" onClick={() => mend(fix)}>
          {wordsOf(fix)}
        </button>
      ))}
    </p>
  );
}

/** A text in place of that of a field of a row. */
interface RowFix {
  label: string;
  text: string;
}

const fixOf = ({ remedy, text, label }: Suggestion): RowFix => ({
  label: label ?? wholeWords.there?.remedyWords[remedy] ?? remedy,
  text,
});

const fixesOfProblem = ({ suggestion, choices }: Problem): RowFix[] =>
  [...(suggestion ? [suggestion] : []), ...choices].map(fixOf);

function fixesOfNote({ fact, suggestions }: Note): RowFix[] {
  const units: RowFix[] = [];
  if (fact.kind === "angle-unit-assumed") {
    if (fact.inDegrees) units.push({ label: fixWords.degrees, text: fact.inDegrees });
    if (fact.inRadians) units.push({ label: fixWords.radians, text: fact.inRadians });
  }
  return [...units, ...suggestions.map(fixOf)];
}

export function Rows({
  store,
  rig,
  report,
  change,
}: {
  store: Store;
  rig: Rig;
  report: FramesReport | undefined;
  change: Change;
}) {
  const { rows } = rig;
  const set = (at: number, part: Partial<Row>) =>
    change({ rows: rows.map((row, place) => (place === at ? { ...row, ...part } : row)) });
  return (
    <section class="frames-known" aria-labelledby="frames-known">
      <h2 id="frames-known">{words.known}</h2>
      <p class="frames-say">{words.say}</p>
      <ol class="frames-rows">
        {rows.map((row, at) => (
          <OneRow
            key={at}
            store={store}
            at={at}
            row={row}
            read={report?.poses[at]}
            onChange={(part) => set(at, part)}
            onRemove={() => change({ rows: rows.filter((_, place) => place !== at) })}
          />
        ))}
      </ol>
      <p class="frames-buttons">
        <button
          type="button"
          class="quiet"
          disabled={rows.length >= mostRows}
          onClick={() => change({ rows: [...rows, emptyRow] })}
        >
          {words.add}
        </button>
        <span class="examples">
          <span>{words.examples}</span>
          {examples.map(({ name, frames }) => (
            <a key={name} href={store.linkTo({ frames })}>
              {words.exampleNames[name]}
            </a>
          ))}
        </span>
      </p>
    </section>
  );
}

function OneRow({
  store,
  at,
  row,
  read,
  onChange,
  onRemove,
}: {
  store: Store;
  at: number;
  row: Row;
  read: FramesReport["poses"][number] | undefined;
  onChange: (part: Partial<Row>) => void;
  onRemove: () => void;
}) {
  const { digits, unit } = store.state.value;
  const problems = read?.problems ?? [];
  const notes = (read?.notes ?? []).filter(({ stops }) => stops);
  const told = `frames-row-${at}`;
  const problemOf = (field: Problem["field"]) =>
    problems.find((problem) => problem.field === field);
  const fixes = (field: Field, offered: readonly RowFix[]) =>
    offered.map(({ label, text }) => (
      <button
        key={`${label} ${text}`}
        type="button"
        class="fix"
        onClick={() => {
          store.step();
          onChange({ [field]: text });
          store.step();
          announce(doneWords(label));
          // The button is gone with what it mended.
          document.getElementById(`${told}-${field}`)?.focus();
        }}
      >
        <span class="fix-label">{label}</span>
        <code class="fix-text">{text}</code>
      </button>
    ));
  const name = (field: "child" | "parent") => (
    <input
      id={`${told}-${field}`}
      class="frame-name"
      aria-label={words.ofRow(at, words.columns[field])}
      aria-invalid={problemOf(field) !== undefined}
      aria-describedby={told}
      placeholder={words.columns[field]}
      autocomplete="off"
      autocapitalize="off"
      spellcheck={false}
      value={row[field]}
      onInput={(event) => onChange({ [field]: event.currentTarget.value })}
    />
  );
  const text = (field: "rotation" | "position") => (
    <div class={`field frame-${field}`}>
      <label for={`${told}-${field}`}>
        <span class="visually-hidden">{words.ofRow(at, "")}</span>
        {words.columns[field]}
      </label>
      <div class="field-box">
        <MarkedText
          id={`${told}-${field}`}
          text={row[field]}
          problem={problemOf(field)}
          describedBy={told}
          onInput={(typed) => onChange({ [field]: typed })}
        />
      </div>
    </div>
  );
  return (
    <li class="frames-row">
      <div class="frames-pose">
        <span class="frame-names">
          {name("child")} <span>{words.inWord}</span> {name("parent")}
        </span>
        {text("rotation")}
        {text("position")}
        <select
          aria-label={words.ofRow(at, words.columns.convention)}
          title={words.columns.convention}
          value={row.convention}
          onChange={(event) => {
            const chosen = event.currentTarget.value;
            onChange({ convention: rowConventions.find((known) => known === chosen) ?? "" });
          }}
        >
          {rowConventions.map((convention) => (
            <option key={convention} value={convention}>
              {words.conventionNames[convention]}
            </option>
          ))}
        </select>
        <button type="button" class="frame-remove" aria-label={words.remove(at)} onClick={onRemove}>
          ×
        </button>
      </div>
      <div id={told} class="frames-told">
        {problems.map((problem) => (
          <p key={problem.field} class="frames-problem">
            {words.problemOf(problem)}
            {fixes(problem.field, fixesOfProblem(problem))}
          </p>
        ))}
        {notes.map((note) => (
          <p key={note.fact.kind}>
            {noteWords(note, digits, unit)}
            {fixes(note.field, fixesOfNote(note))}
          </p>
        ))}
        {read?.position && row.position.trim() === "" && (
          <p>
            {words.at} <code>{shownArray(read.position, digits)}</code>
          </p>
        )}
      </div>
    </li>
  );
}
