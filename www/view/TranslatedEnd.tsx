// One end of a translation: its numbers, its matrix, its product, its line of code.
import type { ComponentChildren } from "preact";
import type { Digits } from "../address.ts";
import { endValues } from "../copy/values.ts";
import type { Assumption, Engine, TranslatedEnd } from "../engine.ts";
import { Copy } from "./Copy.tsx";
import {
  accentOf,
  familyWords,
  knownWords,
  languageNames,
  libraryWith,
  listed,
  nonUnitWords,
  notEstablished,
  productWords,
  takesWords,
  vectorWords,
} from "./library_words.ts";
import { Of } from "./TranslationWhy.tsx";
import { ArrayRow, Matrix } from "./Value.tsx";
import { arrowOf, lettersOf } from "./words.ts";

export function EndColumn({
  side,
  name,
  end,
  isUnit,
  engine,
  digits,
}: {
  side: "from" | "to";
  name: string;
  end: TranslatedEnd;
  /** Whether the numbers have norm 1. */
  isUnit: boolean;
  engine: Engine;
  digits: Digits;
}) {
  const library = libraryWith(engine, end.library);
  const values = endValues(name, end);
  const { assumed, components, constructorOrder, matrix } = end;
  const otherOrder =
    constructorOrder !== undefined && constructorOrder !== end.order ? constructorOrder : undefined;
  return (
    <section class={`card column ${accentOf(end.family)}`} aria-labelledby={`${side}-name`}>
      <header>
        <h2 id={`${side}-name`}>{name}</h2>
        {library && <span class="badge">{knownWords[library.known][0]}</span>}
        <p class="axes">
          <span>{end.handedness ? productWords[end.handedness] : `product ${notEstablished}`}</span>{" "}
          <span>{lettersOf[end.order]}</span> <span>{arrowOf(end.direction)}</span>
        </p>
        <p class="effect">
          <Of action={end.action} /> takes {takesWords[end.direction]}.
        </p>
        {assumed.map((what) => (
          <p key={what} class="assumed">
            {assumptions[what]}
          </p>
        ))}
      </header>
      {end.construct !== undefined && (
        <CodeLines
          title={library ? languageNames[library.language] : "code"}
          lines={[end.construct, end.usual]}
          of={name}
        />
      )}
      {matrix ? (
        <div class="matrices">
          <Matrix
            name={`matrix of ${name}`}
            symbol={
              <>
                {library && "as printed, "}
                <Of action={matrix.form} />
              </>
            }
            caption={vectorWords[matrix.vectors]}
            rows={matrix.rows}
            value={values.matrix}
            digits={digits}
          />
        </div>
      ) : (
        <p class="absent">What it prints as the matrix is {notEstablished}.</p>
      )}
      <div class="rows">
        {otherOrder && (
          <ArrayRow
            name={`q of ${name} as its constructor takes it`}
            symbol={lettersOf[otherOrder]}
            numbers={
              otherOrder === "scalar-first"
                ? [components.w, components.x, components.y, components.z]
                : [components.x, components.y, components.z, components.w]
            }
            digits={digits}
            note="as its constructor takes them"
            value={values.reordered}
          />
        )}
        <WordRow symbol={<code>a * b</code>}>
          {end.firstToAct === undefined
            ? `which of the two acts first is ${notEstablished}`
            : `acts on a vector first by ${end.firstToAct === "right" ? "b, then by a" : "a, then by b"}`}
        </WordRow>
        <WordRow symbol="is called">
          {end.family === undefined ? (
            `its product is ${notEstablished}`
          ) : (
            <>
              <strong>{familyWords[end.family][0]}</strong>: {familyWords[end.family][1]}
            </>
          )}
        </WordRow>
        {library && !isUnit && (
          <WordRow symbol="norm not 1">
            {listed(library.nonUnit, nonUnitWords) || `what it makes of it is ${notEstablished}`}
          </WordRow>
        )}
      </div>
      {library?.note !== undefined && <p class="end-note">{library.note}</p>}
    </section>
  );
}

const assumptions: Record<Assumption, string> = {
  order: "Assumed: the order of its numbers is not established, and is taken as x y z w.",
  action: "Assumed: what it does to a vector is not established, and is taken as R(q).",
};

function WordRow({ symbol, children }: { symbol: ComponentChildren; children: ComponentChildren }) {
  return (
    <div class="row row-words">
      <span class="row-symbol">{symbol}</span>
      <span>{children}</span>
    </div>
  );
}

/** Lines of code, each with a copy button of its own. */
export function CodeLines({
  title,
  lines,
  of,
}: {
  title: string;
  lines: readonly (string | undefined)[];
  of: string;
}) {
  return (
    <div class="code-lines">
      <span class="code-title">{title}</span>
      {lines
        .filter((line) => line !== undefined)
        .map((line, at) => (
          <div key={at} class="code-line">
            <code>{line}</code>
            <Copy of={at === 0 ? `the line of code of ${of}` : `the call of ${of}`} text={line} />
          </div>
        ))}
    </div>
  );
}
