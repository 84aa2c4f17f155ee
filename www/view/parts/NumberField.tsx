// A number of the result that can be edited in its place.
import { useLayoutEffect, useRef, useState } from "preact/hooks";
import { applyFirst } from "../../action/fixes.ts";
import { inPlace } from "../../dom/hold.ts";
import type { Digits, Unit } from "../../model/page_state.ts";
import { shown } from "../../number/format.ts";
import { type Stride, stepped } from "../../number/stepping.ts";
import type { Content } from "../../state/history.ts";
import { numberProblem } from "../../words/parts/number_field.ts";
import {
  leave,
  type NumberGroup,
  numberOf,
  partOf,
  plainNumber,
  rowsOf,
  shownNumbers,
  stopAt,
  stopOf,
  write,
} from "./number_group.ts";
import { placeAfter } from "./roving.ts";
import "./number_field.css";

/** What the arrow keys add. */
const steps = { degrees: 1, radians: 0.01, none: 0.01 };

type FieldKey = KeyboardEvent & { currentTarget: HTMLInputElement };

export function NumberField({
  group,
  at,
  label,
  digits,
  text,
  unit = "none",
}: {
  group: NumberGroup;
  /** The place in the group. */
  at: number;
  label: string;
  digits: Digits;
  /** The number for reading, where it is aligned with others. */
  text?: string | undefined;
  unit?: Unit | "none";
}) {
  const { store } = group;
  const [isEdited, setEdited] = useState(false);
  /** The state before the edit, for Escape. */
  const before = useRef<Pick<Content, "quaternion" | "matrix">>(undefined);
  const typed = group.typed?.[at];
  const isExpression = typed !== undefined && plainNumber(typed) === undefined;
  const reading = isExpression ? typed : (text ?? shown(shownNumbers(group)[at] ?? 0, digits));
  const isWrong = group.isWrong(at);
  const input = useRef<HTMLInputElement>(null);
  // While it is edited its place stays as it is, so that nothing moves: it covers its neighbours.
  const place = useRef(reading);
  if (!isEdited) place.current = reading;
  useLayoutEffect(() => {
    if (!isEdited || input.current === null) return;
    widen(input.current);
    keepWithin(input.current);
  });
  useLayoutEffect(() => {
    const field = input.current;
    if (isEdited || field === null) return;
    field.style.left = "0";
    if (field === document.activeElement) field.select();
  }, [isEdited]);

  const remember = () => {
    const { quaternion, matrix } = store.state.peek();
    before.current = { quaternion, matrix };
    setEdited(true);
  };
  const begin = (field: HTMLInputElement) => {
    if (field !== document.activeElement) field.focus();
    remember();
    select(field, partOf(group, at));
  };
  const end = () => {
    setEdited(false);
    store.step();
  };

  /** The number has the focus and is not edited: what is typed takes its place. */
  const onKeyOfStop = (event: FieldKey) => {
    const field = event.currentTarget;
    const next = placeAfter(event, at, rowsOf(group));
    if (next !== undefined) {
      event.preventDefault();
      fieldsOf(group)[next]?.focus();
    } else if (event.key === "F2" || (event.key === "Enter" && !event.altKey)) {
      event.preventDefault();
      begin(field);
    } else if (event.key === "Enter") {
      event.preventDefault();
      applyFirst(store, "quaternion");
    } else if (event.key === " ") {
      event.preventDefault();
    } else {
      // Undo moves the cursor into it.
      field.select();
    }
  };

  const onKeyOfEdited = (event: FieldKey) => {
    const field = event.currentTarget;
    const direction = directionOf(event.key);
    if (direction !== undefined && !event.ctrlKey && !event.metaKey) {
      event.preventDefault();
      const number = numberOf(store, field.value);
      if (number === undefined) return;
      const next = stepped(number, steps[unit], strideOf(event), direction);
      inPlace(field, () => write(group, at, next));
      select(field, next);
    } else if (event.key === "Enter" && event.altKey) {
      event.preventDefault();
      if (applyFirst(store, "quaternion")) begin(field);
    } else if (event.key === "Enter" && !event.isComposing) {
      event.preventDefault();
      end();
    } else if (event.key === "Escape" && before.current !== undefined) {
      event.preventDefault();
      const parts = before.current;
      if (store.state.peek().quaternion !== parts.quaternion) {
        inPlace(field, () => store.set(parts, { as: `editing ${group.id} ${at}` }));
      }
      end();
    }
  };

  const problem = isEdited && isWrong ? store.problemOf("quaternion") : undefined;
  const value = isEdited ? partOf(group, at) : reading;
  const field = (
    <span class={`number-box digits-${digits}`} data-text={place.current}>
      <input
        ref={input}
        type="text"
        class={`number ${isExpression ? "expression" : ""} ${isEdited ? "editing" : ""}`}
        // A group is one stop of the Tab key.
        tabIndex={stopOf(group) === at ? 0 : -1}
        aria-label={label}
        value={value}
        spellcheck={false}
        autocomplete="off"
        autocapitalize="off"
        aria-invalid={isWrong}
        aria-describedby={isWrong ? "problem-quaternion" : undefined}
        // A press edits at once, with the whole number selected; a second one places the cursor.
        onMouseDown={(event) => {
          if (event.button !== 0 || isEdited) return;
          event.preventDefault();
          begin(event.currentTarget);
        }}
        onFocus={(event) => {
          stopAt(group, at);
          widen(event.currentTarget);
          if (!isEdited) event.currentTarget.select();
        }}
        onInput={({ currentTarget: field }) => {
          if (!isEdited) remember();
          inPlace(field, () => write(group, at, field.value));
        }}
        onKeyDown={isEdited ? onKeyOfEdited : onKeyOfStop}
        // What is read is rounded, what is copied is not.
        onCopy={(event) => {
          if (isEdited) return;
          event.preventDefault();
          event.clipboardData?.setData("text/plain", partOf(group, at));
        }}
        onCut={(event) => {
          if (!isEdited) begin(event.currentTarget);
        }}
        onBlur={(event) => {
          // The window lost the focus, and the field keeps it within the window.
          if (event.currentTarget === document.activeElement) return;
          end();
          const next = event.relatedTarget;
          if (!(next instanceof HTMLInputElement && next.dataset["group"] === group.id))
            leave(group);
        }}
        data-group={group.id}
      />
    </span>
  );
  return (
    <>
      {field}
      {/* It is read aloud as the description of the field, from where all problems stand. */}
      {problem && (
        <span class="number-problem" aria-hidden="true">
          {numberProblem(value, problem)}
        </span>
      )}
    </>
  );
}

function fieldsOf({ id }: NumberGroup) {
  return document.querySelectorAll<HTMLInputElement>(`[data-group="${id}"]`);
}

function select(field: HTMLInputElement, text: string) {
  field.value = text;
  field.select();
}

/** A number with the focus may take as much room as it has characters. */
function widen(field: HTMLInputElement) {
  field.style.setProperty("--exact", `calc(${field.value.length + 1}ch + 8px)`);
}

/** Pixels of the outline, which what scrolls would cut. */
const outline = 3;

/** Moves a field that is wider than its place to the left, as far as the matrix or the page ends. */
function keepWithin(field: HTMLInputElement) {
  const within = field.closest(".matrix-scroll, #page")?.getBoundingClientRect();
  if (within === undefined) return;
  field.style.left = "0";
  field.style.maxWidth = `${within.width - 2 * outline}px`;
  const beyond = field.getBoundingClientRect().right + outline - within.right;
  if (beyond > 0) field.style.left = `${-beyond}px`;
}

function directionOf(key: string): 1 | -1 | undefined {
  if (key === "ArrowUp") return 1;
  return key === "ArrowDown" ? -1 : undefined;
}

function strideOf({ shiftKey, altKey }: KeyboardEvent): Stride {
  if (shiftKey) return "long";
  return altKey ? "short" : "usual";
}
