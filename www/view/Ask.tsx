// What is asked: text fields, the declared convention, the digits shown.
import type { ComponentChildren } from "preact";
import { useId, useRef } from "preact/hooks";
import type { Digits, Preset } from "../address.ts";
import type { Field, Problem } from "../engine.ts";
import type { Freshness, Store } from "../state.ts";

interface TextFieldProps {
  store: Store;
  field: Field;
  symbol: string;
  label: string;
  size: "hero" | "plain";
  text: string;
  onText: (text: string) => void;
}

/** A field for text in any form, with the place of a problem marked in the text itself. */
export function TextField({ store, field, symbol, label, size, text, onText }: TextFieldProps) {
  const id = useId();
  const mirror = useRef<HTMLPreElement>(null);
  const problem = store.problemOf(field);
  return (
    <div class={`field field-${size}`}>
      <div class="field-box">
        <label for={id} class="field-label">
          <span class="visually-hidden">{label}</span>
          <var>{symbol}</var>
        </label>
        <div class="field-text">
          <pre class="field-mirror" aria-hidden="true" ref={mirror}>
            {problem ? <Marked text={text} problem={problem} /> : text}
            {"\n"}
          </pre>
          <textarea
            id={id}
            name={field}
            rows={1}
            spellcheck={false}
            autocomplete="off"
            autocapitalize="off"
            value={text}
            aria-invalid={problem !== undefined}
            aria-describedby={problem && problemId(field)}
            onInput={(event) => onText(event.currentTarget.value)}
            onScroll={(event) => {
              if (mirror.current) mirror.current.scrollTop = event.currentTarget.scrollTop;
            }}
          />
        </div>
      </div>
    </div>
  );
}

/** The vector that both views turn. */
export function VectorField({ store }: { store: Store }) {
  return (
    <TextField
      store={store}
      field="vector"
      symbol="x"
      label="vector"
      size="plain"
      text={store.state.value.vector}
      onText={(vector) => store.set({ vector })}
    />
  );
}

const problemId = (field: Field) => `problem-${field}`;

/**
 * What is said about the texts: how they were read, or what stands in the way. One place for both,
 * so that nothing moves while a text is typed.
 */
export function AskStatus({
  store,
  fields,
  freshness,
  children,
}: {
  store: Store;
  fields: readonly { field: Field; symbol: string }[];
  /** Of the result below. */
  freshness: Freshness | undefined;
  children: ComponentChildren;
}) {
  const found = fields.flatMap(({ field, symbol }) => {
    const problem = store.problemOf(field);
    return problem ? [{ symbol, problem }] : [];
  });
  return (
    <div class="ask-status">
      {found.length === 0
        ? children
        : found.map(({ symbol, problem }, at) => (
            <div key={symbol} class="problem" id={problemId(problem.field)}>
              <p class="problem-head">
                <span class="problem-message">
                  <var>{symbol}</var>: {problem.message}.
                </span>{" "}
                {at === 0 && <span class="old-result">{standsBelow(freshness)}</span>}
              </p>
              <p>
                <span class="problem-key">Expected</span> {problem.expected}.{" "}
                <span class="problem-key">Try</span> {problem.hint}.
              </p>
            </div>
          ))}
    </div>
  );
}

function standsBelow(freshness: Freshness | undefined): string {
  return freshness === "opening"
    ? "What stands below is the example that the page opens with."
    : "What stands below is the last result, from before this problem.";
}

/** The text with the place of the problem marked; a place of no width takes what stands there. */
function Marked({ text, problem }: { text: string; problem: Problem }) {
  const { start, end } = problem.span;
  return (
    <>
      {text.slice(0, start)}
      <mark>{start === end ? " " : text.slice(start, end)}</mark>
      {text.slice(end)}
    </>
  );
}

const presets: { preset: Preset; name: string; meaning: string }[] = [
  { preset: "hamilton", name: "Hamilton", meaning: "w x y z, ij = k, body to world" },
  { preset: "jpl", name: "JPL", meaning: "x y z w, ij = −k, world to body" },
];

/** Declares how the text is meant. */
export function ConventionSwitch({ store }: { store: Store }) {
  const { preset: chosen } = store.state.value;
  return (
    <fieldset class="switch">
      <legend class="visually-hidden">The text is meant as</legend>
      {presets.map(({ preset, name, meaning }) => (
        <label key={preset} class={`switch-choice ${preset}`}>
          <input
            type="radio"
            name="convention"
            value={preset}
            checked={preset === chosen}
            onChange={() => store.set({ preset })}
          />
          <span class="switch-name">{name}</span>
          <span class="switch-meaning">{meaning}</span>
        </label>
      ))}
    </fieldset>
  );
}

const digitChoices: { digits: Digits; name: string }[] = [
  { digits: "4", name: "4" },
  { digits: "6", name: "6" },
  { digits: "all", name: "all" },
];

/** Chooses how many decimals are shown. */
export function DigitsSwitch({ store }: { store: Store }) {
  const { digits: chosen } = store.state.value;
  return (
    <fieldset class="digits">
      <legend>Decimals</legend>
      {digitChoices.map(({ digits, name }) => (
        <label key={digits}>
          <input
            type="radio"
            name="digits"
            value={digits}
            checked={digits === chosen}
            onChange={() => store.set({ digits })}
          />
          <span>{name}</span>
        </label>
      ))}
    </fieldset>
  );
}
