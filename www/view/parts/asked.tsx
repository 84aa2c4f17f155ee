// What the bodies of folds share that ask the whole core: fields, rows, and the last good answer.
import type { ComponentChildren } from "preact";
import { useId, useRef } from "preact/hooks";
import type { Outcome, Problem } from "../../engine.ts";
import { shown } from "../../number/format.ts";
import type { Asks, Store } from "../../state/store.ts";
import { problemLine } from "../../words/parts/asked.ts";
import { Copy } from "./Copy.tsx";
import { MarkedText } from "./MarkedText.tsx";
import "./result.css";
import "./text_field.css";
import "./asked.css";

type Good<Status> = Extract<Outcome, { status: Status }>;

/** The last good answer to what is asked beside the view, and the problems of the texts as they are now. */
export function useAsked<Status extends Outcome["status"]>(
  store: Store,
  asks: Asks,
  status: Status,
): { report: Good<Status> | undefined; problems: readonly Problem[]; old: string } {
  const last = useRef<Good<Status>>(undefined);
  const answer = store.beside(asks).value;
  if (answer?.status === status) last.current = answer as Good<Status>;
  return {
    report: last.current,
    problems: answer?.status === "problems" ? answer.problems : [],
    old: answer?.status === status ? "" : "asked-old",
  };
}

/** A field of a fold, with what is wrong with its text. */
export function AskedText({
  label,
  symbol,
  text,
  problem,
  onInput,
}: {
  label: string;
  symbol: ComponentChildren;
  text: string;
  problem: Problem | undefined;
  onInput: (text: string) => void;
}) {
  const id = useId();
  return (
    <div class="field field-plain">
      <div class="field-box">
        <label for={id} class="field-label">
          <span class="visually-hidden">{label}</span>
          <var>{symbol}</var>
        </label>
        <MarkedText
          id={id}
          text={text}
          problem={problem}
          describedBy={problem && `${id}-problem`}
          onInput={onInput}
        />
      </div>
      {problem && (
        <p class="problem" id={`${id}-problem`}>
          {problemLine(problem)}
        </p>
      )}
    </div>
  );
}

/** A row with one number, or with its angle in words. */
export function ScalarRow({
  store,
  name,
  number,
  words,
  note,
}: {
  store: Store;
  name: string;
  number: number;
  /** In place of the number. */
  words?: string;
  note?: string;
}) {
  return (
    <div class="row">
      <span class="row-symbol">{name}</span>
      <span class="row-value">
        <code>{words ?? shown(number, store.state.value.digits)}</code>
        {note !== undefined && <span class="row-note">{note}</span>}
      </span>
      <Copy of={name} text={`${number}`} />
    </div>
  );
}
