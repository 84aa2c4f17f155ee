// One end of a translation: its numbers, its matrix, its product, its line of code.
import type { ComponentChildren } from "preact";
import { endValues } from "../../copy/end_values.ts";
import type { Engine, TranslatedEnd } from "../../engine.ts";
import { arrayOf } from "../../model/component_order.ts";
import type { Digits } from "../../model/page_state.ts";
import { arrowOf, lettersOf } from "../../words/conventions.ts";
import {
  familyWords,
  knownWords,
  languageNames,
  nonUnitWords,
  numbersWords,
  productWords,
  resultWords,
  vectorWords,
} from "../../words/library_behaviour.ts";
import * as words from "../../words/translate/end_column.tsx";
import { Copy } from "../parts/Copy.tsx";
import { accentOf, libraryWith } from "../parts/library.ts";
import { ArrayRow, Matrix } from "../parts/Value.tsx";
import { Of } from "./Why.tsx";
import "../parts/result.css";
import "./end_column.css";

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
  // Of other norms a library may print something else, which is not known to the last digit.
  const matrixOf = isUnit || library?.nonUnit?.matrix === "normalised" ? "as-printed" : "of-unit";
  const values = endValues(name, end, matrixOf, engine.describe);
  const { assumed, components, constructorOrder, matrix } = end;
  const otherOrder =
    constructorOrder !== undefined && constructorOrder !== end.order ? constructorOrder : undefined;
  return (
    <section class={`card column ${accentOf(end.family)}`} aria-labelledby={`${side}-name`}>
      <header>
        <h2 id={`${side}-name`}>{name}</h2>
        {library && <span class="badge">{knownWords[library.known][0]}</span>}
        <p class="axes">
          {end.numbers ? (
            <span>{numbersWords(end.numbers)}</span>
          ) : (
            <>
              <span>{end.handedness ? productWords[end.handedness] : words.product}</span>{" "}
              <span>{lettersOf[end.order]}</span>
            </>
          )}{" "}
          <span>{arrowOf(end.direction)}</span>
        </p>
        <p class="effect">
          {end.numbers
            ? words.itTakes(end.direction)
            : words.takes(<Of action={end.action} />, end.direction)}
        </p>
        {library?.axes && <p class="effect">{words.axes(library.axes)}</p>}
        {assumed.map((what) => (
          <p key={what} class="assumed">
            {words.assumptions[what]}
          </p>
        ))}
      </header>
      {end.construct !== undefined && (
        <CodeLines
          title={library ? languageNames[library.language] : words.code}
          lines={[end.construct, end.usual]}
          of={name}
        />
      )}
      {matrix ? (
        <div class="matrices">
          <Matrix
            name={words.matrix(name)}
            symbol={
              <>
                {(library || matrixOf === "of-unit") && words.matrixOf[matrixOf]}
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
        !end.numbers && <p class="absent">{words.noMatrix}</p>
      )}
      {!end.numbers && (
        <div class="rows">
          {otherOrder && (
            <ArrayRow
              name={words.constructed(name)}
              symbol={lettersOf[otherOrder]}
              numbers={arrayOf(components, otherOrder)}
              digits={digits}
              note={words.constructedNote}
              value={values.reordered}
            />
          )}
          <WordRow symbol={<code>a * b</code>}>
            {end.firstToAct === undefined ? words.noFirst : words.first[end.firstToAct]}
          </WordRow>
          <WordRow symbol={words.called}>
            {end.family === undefined ? (
              words.noFamily
            ) : (
              <>
                <strong>{familyWords[end.family][0]}</strong>: {familyWords[end.family][1]}
              </>
            )}
          </WordRow>
          {library && !isUnit && (
            <WordRow symbol={words.nonUnit}>
              {resultWords(library.nonUnit, nonUnitWords) || words.noNonUnit}
            </WordRow>
          )}
        </div>
      )}
      {library?.note !== undefined && <p class="end-note">{library.note}</p>}
      {library?.doubt !== undefined && (
        <p class="end-note">
          <strong>{words.doubt}</strong> {library.doubt}
        </p>
      )}
    </section>
  );
}

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
            <Copy of={at === 0 ? words.copiedLine(of) : words.copiedCall(of)} text={line} />
          </div>
        ))}
    </div>
  );
}
