// One record of the table: everything that is known of a library, and how.
import type { ComponentChildren } from "preact";
import { opening, type PageState, toFragment } from "../address.ts";
import type { Code, Endpoint, Library } from "../engine.ts";
import type { Store } from "../state.ts";
import { Copy } from "./Copy.tsx";
import { EvidenceOf } from "./Evidence.tsx";
import {
  axisAngleWords,
  establishedOf,
  familyWords,
  halfTurnWords,
  knownWords,
  languageNames,
  listed,
  nonUnitWords,
  notEstablished,
  signWords,
  slerpWords,
  takesWords,
  zeroWords,
} from "./library_words.ts";

export function LibraryRecord({ library, store }: { library: Library; store: Store }) {
  const { family, action } = establishedOf(store.engine.endOf(library.id));
  const linkTo = (change: Partial<PageState>) =>
    `#${toFragment({ ...store.state.value, ...change })}`;
  const end: Endpoint = { kind: "library", id: library.id };
  return (
    <article class="record" aria-label={`The record of ${library.name}`}>
      <p class="record-links">
        <a class="quiet" href={linkTo({ view: "translate", from: end })}>
          Translate from
        </a>
        <a class="quiet" href={linkTo({ view: "translate", to: end })}>
          Translate to
        </a>
        <span class="record-link">
          link to this record
          <Copy of="the link to this record" text={permalink(library.id)} />
        </span>
      </p>
      {library.note !== undefined && <p class="record-note">{library.note}</p>}
      <div class="record-parts">
        <div>
          <h3>What it means</h3>
          <dl>
            <Fact name="Called">
              {family && (
                <>
                  <strong>{familyWords[family][0]}</strong>: {familyWords[family][1]}
                </>
              )}
            </Fact>
            <Fact name="Direction">
              {library.direction && action && (
                <>
                  {action}(q) takes {takesWords[library.direction]}, as documented
                </>
              )}
            </Fact>
            {library.euler?.map(({ call, means }, at) => (
              <Fact key={call} name={at === 0 ? "Euler angles" : ""}>
                <code>{call}</code> is <code>{means.replaceAll("-", "−")}</code>
              </Fact>
            ))}
            <Fact name="+θ about z">{library.axisAngle && axisAngleWords[library.axisAngle]}</Fact>
            <Fact name="Of a matrix">
              {library.matrixToQuaternion &&
                `${signWords[library.matrixToQuaternion.sign]}; ${halfTurnWords[library.matrixToQuaternion.halfTurns]}`}
            </Fact>
            <Fact name="slerp">{library.slerp && slerpWords[library.slerp]}</Fact>
            <Fact name="Norm 2">{listed(library.nonUnit, nonUnitWords)}</Fact>
            <Fact name="Zero">{listed(library.zero, zeroWords)}</Fact>
          </dl>
        </div>
        <div>
          <h3>{languageNames[library.language]}</h3>
          <CodeOf code={library.code} />
          <h3>How it is known</h3>
          <dl>
            <Fact name={knownWords[library.known][0]}>{knownWords[library.known][1]}</Fact>
            {library.calls !== undefined && (
              <Fact name="Calls">
                <code>{library.calls}</code>
              </Fact>
            )}
            {library.source && (
              <Fact name="Source">
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

const codeNames: Record<keyof Code, string> = {
  construct: "construct",
  rotate: "rotate v",
  matrix: "matrix",
  product: "product",
  fromMatrix: "of a matrix",
  print: "print",
};

function CodeOf({ code }: { code: Code | undefined }) {
  const lines = (Object.keys(codeNames) as (keyof Code)[]).flatMap((name) => {
    const line = code?.[name];
    return line === undefined ? [] : [{ name, line: line.replace(/\{([wxyz])\}f?/g, "$1") }];
  });
  if (lines.length === 0) return <p class="none">{notEstablished}</p>;
  return (
    <dl class="record-code">
      {lines.map(({ name, line }) => (
        <div key={name} class="record-fact">
          <dt>{codeNames[name]}</dt>
          <dd>
            <code>{line}</code>
            <Copy of={`the call: ${codeNames[name]}`} text={line} />
          </dd>
        </div>
      ))}
    </dl>
  );
}
