// Text that is typed, with the place of its problem marked in it.
import { useRef } from "preact/hooks";
import type { Problem } from "../../engine.ts";

/** A text area over a copy of its text, which shows where the problem is. */
export function MarkedText({
  id,
  name,
  text,
  problem,
  isWrong = problem !== undefined,
  describedBy,
  onInput,
  onEnter,
  onAltEnter,
}: {
  id: string;
  name?: string;
  text: string;
  problem: Problem | undefined;
  isWrong?: boolean;
  describedBy: string | undefined;
  onInput: (text: string) => void;
  /** What the Enter key does; it starts a new line where this is absent. */
  onEnter?: (() => void) | undefined;
  /** What Enter does with the Alt key held. */
  onAltEnter?: () => void;
}) {
  const mirror = useRef<HTMLPreElement>(null);
  return (
    <div class="field-text">
      <pre class="field-mirror" aria-hidden="true" ref={mirror}>
        {problem ? <Marked text={text} problem={problem} /> : text}
        {"\n"}
      </pre>
      <textarea
        id={id}
        name={name}
        rows={1}
        spellcheck={false}
        autocomplete="off"
        autocapitalize="off"
        value={text}
        aria-invalid={isWrong}
        aria-describedby={describedBy}
        onInput={(event) => onInput(event.currentTarget.value)}
        onKeyDown={(event) => {
          const does = event.altKey ? onAltEnter : onEnter;
          if (event.key !== "Enter" || event.shiftKey || event.isComposing || !does) return;
          event.preventDefault();
          does();
        }}
        onScroll={(event) => {
          if (mirror.current) mirror.current.scrollTop = event.currentTarget.scrollTop;
        }}
      />
    </div>
  );
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
