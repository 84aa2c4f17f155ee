// One record of the table: everything that is known of a library, and how.
import type { ComponentChildren } from "preact";
import { toFragment } from "../../address/fragment.ts";
import type { Code, Endpoint, Library, RecordNumbers } from "../../engine.ts";
import { opening, type PageState } from "../../model/page_state.ts";
import type { Store } from "../../state/store.ts";
import { lettersOf } from "../../words/conventions.ts";
import * as words from "../../words/libraries/record.tsx";
import {
  axisAngleWords,
  familyWords,
  halfTurnWords,
  inUnit,
  kindNames,
  knownWords,
  languageNames,
  meansWords,
  nonUnitWords,
  notEstablished,
  numbersWords,
  resultWords,
  signWords,
  slerpWords,
  takesWords,
  zeroWords,
} from "../../words/library_behaviour.ts";
import { Copy } from "../parts/Copy.tsx";
import { establishedOf, isLibrary } from "../parts/library.ts";
import { EvidenceOf } from "./Evidence.tsx";
import "./record.css";

export function LibraryRecord({ library, store }: { library: Library; store: Store }) {
  const { family, action } = establishedOf(store.engine.describeLibrary(library.id));
  const linkTo = (change: Partial<PageState>) =>
    `#${toFragment({ ...store.state.value, ...change })}`;
  const end: Endpoint = { kind: "library", id: library.id };
  const { arrayOrder, numbers, printedOrder } = library;
  const hasCalls = isLibrary(library);
  return (
    <article class="record" aria-label={words.title(library.name)}>
      <p class="record-links">
        <a class="quiet" href={linkTo({ view: "translate", from: end })}>
          {words.from}
        </a>
        <a class="quiet" href={linkTo({ view: "translate", to: end })}>
          {words.to}
        </a>
        <span class="record-link">
          {words.link}
          <Copy of={words.copiedLink} text={permalink(library.id)} />
        </span>
      </p>
      {library.note !== undefined && <p class="record-note">{library.note}</p>}
      {library.doubt !== undefined && (
        <p class="record-note">
          <strong>{words.doubt}</strong> {library.doubt}
        </p>
      )}
      <div class="record-parts">
        <div>
          <h3>{words.means}</h3>
          <dl>
            {library.kind && <Fact name={words.kind}>{kindNames[library.kind]}</Fact>}
            {numbers && <Fact name={words.writes}>{written(numbers)}</Fact>}
            {printedOrder && arrayOrder && (
              <Fact name={words.order}>
                {words.printsAndStores(lettersOf[printedOrder], lettersOf[arrayOrder])}
              </Fact>
            )}
            {!numbers && (
              <Fact name={words.called}>
                {family && (
                  <>
                    <strong>{familyWords[family][0]}</strong>: {familyWords[family][1]}
                  </>
                )}
              </Fact>
            )}
            <Fact name={words.direction}>
              {library.direction &&
                (numbers
                  ? words.leads(takesWords[library.direction])
                  : action && words.takes(action, takesWords[library.direction]))}
            </Fact>
            {library.axes && <Fact name={words.axes}>{library.axes}</Fact>}
            {library.euler?.map(({ call, means }, at) => (
              <Fact key={call} name={at === 0 ? words.euler : ""}>
                {words.eulerCall(call, means.replaceAll("-", "−"))}
              </Fact>
            ))}
            {hasCalls && <Calls library={library} />}
          </dl>
        </div>
        <div>
          {!numbers && (
            <>
              <h3>{languageNames[library.language]}</h3>
              <CodeOf code={library.code} />
            </>
          )}
          <h3>{words.known}</h3>
          <dl>
            <Fact name={knownWords[library.known][0]}>{knownWords[library.known][1]}</Fact>
            {library.calls !== undefined && (
              <Fact name={words.calls}>
                <code>{library.calls}</code>
              </Fact>
            )}
            {library.source && (
              <Fact name={words.source}>
                {library.source.text}{" "}
                {library.source.url !== undefined && (
                  <a href={library.source.url} rel="noreferrer">
                    {hostOf(library.source.url)}
                  </a>
                )}
              </Fact>
            )}
          </dl>
        </div>
      </div>
      {library.known === "run" && <EvidenceOf key={library.id} library={library} />}
    </article>
  );
}

/** What numbers stand for the rotation, and how. */
function written(numbers: RecordNumbers) {
  const { means, names, unit } = numbers;
  if (means === undefined) return numbersWords(numbers);
  return words.written(names, inUnit(unit), meansWords(numbers));
}

/** What the calls of a library do, which a file or a device has not. */
function Calls({ library }: { library: Library }) {
  const { axisAngle, matrixToQuaternion, nonUnit, slerp, zero } = library;
  return (
    <>
      <Fact name={words.axisAngle}>{axisAngle && axisAngleWords[axisAngle]}</Fact>
      <Fact name={words.ofMatrix}>
        {matrixToQuaternion &&
          `${signWords[matrixToQuaternion.sign]}; ${halfTurnWords[matrixToQuaternion.halfTurns]}`}
      </Fact>
      <Fact name={words.slerp}>{slerp && slerpWords[slerp]}</Fact>
      <Fact name={words.nonUnit}>{resultWords(nonUnit, nonUnitWords)}</Fact>
      <Fact name={words.zero}>{resultWords(zero, zeroWords)}</Fact>
    </>
  );
}

function permalink(id: string): string {
  const fragment = toFragment({ ...opening, view: "libraries", library: id });
  return `${location.href.split("#")[0]}#${fragment}`;
}

function hostOf(url: string): string {
  return URL.canParse(url) ? new URL(url).host : url;
}

function Fact({ name, children }: { name: string; children: ComponentChildren }) {
  return (
    <div class="record-fact">
      <dt>{name}</dt>
      <dd>{children || <span class="none">{notEstablished}</span>}</dd>
    </div>
  );
}

function CodeOf({ code }: { code: Code | undefined }) {
  const lines = (Object.keys(words.code) as (keyof Code)[]).flatMap((name) => {
    const line = code?.[name];
    return line === undefined ? [] : [{ name, line: line.replace(/\{([wxyz])\}f?/g, "$1") }];
  });
  if (lines.length === 0) return <p class="none">{notEstablished}</p>;
  return (
    <dl class="record-code">
      {lines.map(({ name, line }) => (
        <div key={name} class="record-fact">
          <dt>{words.code[name]}</dt>
          <dd>
            <code>{line}</code>
            <Copy of={words.copiedCall(words.code[name])} text={line} />
          </dd>
        </div>
      ))}
    </dl>
  );
}
