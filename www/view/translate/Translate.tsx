// The Translate view: four numbers from one library or convention to another.
import { toFragment } from "../../address/fragment.ts";
import { endQuaternion } from "../../copy/end_values.ts";
import type { Fact, TranslatedEnd, TranslateReport } from "../../engine.ts";
import { inverseAxes } from "../../model/axis_mapping.ts";
import { type Digits, opening, type PageState } from "../../model/page_state.ts";
import { exact, shown } from "../../number/format.ts";
import type { Store } from "../../state/store.ts";
import { arrowOf } from "../../words/conventions.ts";
import type { EndNames } from "../../words/translate/translate.ts";
import * as words from "../../words/translate/translate.ts";
import { AskStatus } from "../parts/Ask.tsx";
import { CarryLinks } from "../parts/CarryLinks.tsx";
import { nameOf as conventionName } from "../parts/convention_names.ts";
import { accentOf, endName, libraryWith } from "../parts/library.ts";
import { Notes } from "../parts/Notes.tsx";
import { NumberSettings } from "../parts/NumberSettings.tsx";
import { NamedComponents } from "../parts/ReadAs.tsx";
import { TextField } from "../parts/TextField.tsx";
import { UndoRedo } from "../parts/UndoRedo.tsx";
import { ComponentStrip, namesInOrder } from "../parts/Value.tsx";
import { AxesCard } from "./AxesCard.tsx";
import { AxesChoice } from "./AxesChoice.tsx";
import { EndChoice } from "./EndChoice.tsx";
import { EndColumn } from "./EndColumn.tsx";
import { MistakesCard } from "./MistakesCard.tsx";
import { NumbersStrip, namedNumbers } from "./NumbersStrip.tsx";
import { ProductCard } from "./ProductCard.tsx";
import { Why, WhyNumbers } from "./Why.tsx";
import "../parts/result.css";
import "./translate.css";

export { askedOfTranslate } from "./asked.ts";

export function Translate({ store }: { store: Store }) {
  const { digits } = store.state.value;
  const shownResult = store.translate.value;
  return (
    <>
      <section class="ask" aria-label={words.input}>
        <div class="ask-row">
          <TextField store={store} field="quaternion" name="translated" />
          <UndoRedo store={store} />
          <NumberSettings store={store} />
        </div>
        <div class="ends">
          <EndChoice store={store} side="from" />
          <SwapButton store={store} />
          <EndChoice store={store} side="to" />
        </div>
        <Examples store={store} />
        <AxesChoice store={store} />
        <AskStatus store={store} freshness={shownResult?.freshness}>
          {shownResult && <ReadAs report={shownResult.report} store={store} />}
        </AskStatus>
      </section>
      {shownResult && (
        <div class={`result ${shownResult.freshness}`}>
          <Result report={shownResult.report} store={store} digits={digits} />
        </div>
      )}
    </>
  );
}

/** Swaps the ends and carries the numbers over, so that the result is its own mirror image. */
function SwapButton({ store }: { store: Store }) {
  const swap = () => {
    const { from, to, worldAxes, bodyAxes } = store.state.value;
    const result = store.translate.value;
    const isCurrent = result?.freshness === "current";
    const mapping = isCurrent ? result.report.axes : undefined;
    store.set({
      from: to,
      to: from,
      ...(isCurrent && { translated: numbersOf(result.report.to).map(exact).join(" ") }),
      worldAxes: inverseAxes(worldAxes, mapping?.world.mapping),
      bodyAxes: inverseAxes(bodyAxes, mapping?.body.mapping),
    });
  };
  return (
    <button type="button" class="swap" onClick={swap} title={words.swap}>
      <svg viewBox="0 0 20 20" width="20" height="20" aria-hidden="true">
        <path d="M3 7 H16 M12.5 3.5 L16 7 L12.5 10.5 M17 13 H4 M7.5 9.5 L4 13 L7.5 16.5" />
      </svg>
      <span class="visually-hidden">{words.swap}</span>
    </button>
  );
}

const library = (id: string) => ({ kind: "library", id }) as const;

const examples: ({ name: keyof typeof words.exampleNames } & Partial<PageState>)[] = [
  { name: "ceres" },
  {
    name: "px4",
    translated: "0.7071067811865476 0 0 0.7071067811865476",
    from: library("px4-vehicle-attitude"),
    to: library("ros-geometry-msgs"),
    worldAxes: "NED to ENU",
    bodyAxes: "FRD to FLU",
  },
  {
    name: "matlab",
    translated: "[0.9515 0.0381 0.1893 0.2393]",
    from: library("matlab-aerospace"),
    to: library("scipy"),
  },
  {
    name: "camera",
    translated: "0.8 0.2 -0.4 0.4",
    from: {
      kind: "convention",
      convention: {
        order: "scalar-first",
        handedness: "right",
        function: "passive",
        direction: "world-to-body",
        perturbation: "local",
      },
    },
    to: library("eigen"),
  },
  {
    name: "directx",
    translated: "XMVectorSet(0.1f, 0.2f, 0.3f, 0.9273618f)",
    from: library("directxmath"),
    to: library("glm"),
  },
  {
    name: "unity",
    translated: "x: 0.0\ny: 0.0\nz: 0.3827\nw: 0.9239",
    from: library("ros-geometry-msgs"),
    to: library("unity"),
    worldAxes: "ROS to Unity",
    bodyAxes: "ROS to Unity",
  },
];

const openingTranslation = {
  translated: opening.translated,
  from: opening.from,
  to: opening.to,
  worldAxes: opening.worldAxes,
  bodyAxes: opening.bodyAxes,
};

/** Links, so that going back returns to what was typed before. */
function Examples({ store }: { store: Store }) {
  return (
    <div class="examples">
      <span id="examples-label">{words.examples}</span>
      <ul aria-labelledby="examples-label">
        {examples.map(({ name, ...example }) => (
          <li key={name}>
            <a href={`#${toFragment({ ...store.state.value, ...openingTranslation, ...example })}`}>
              {words.exampleNames[name]}
            </a>
          </li>
        ))}
      </ul>
    </div>
  );
}

function ReadAs({ report, store }: { report: TranslateReport; store: Store }) {
  const { digits, unit } = store.state.value;
  const proposed = libraryWith(store.engine, report.proposed);
  return (
    <div class="read-as">
      <p>
        {words.readAs}{" "}
        <NamedComponents quaternion={report.quaternion} digits={digits} unit={unit} />
      </p>
      {proposed && (
        <p class="proposal">
          {words.looksLike(proposed.name)}{" "}
          <button
            type="button"
            class="quiet"
            onClick={() => store.set({ from: library(proposed.id) })}
          >
            {words.translateFrom(proposed.name)}
          </button>
        </p>
      )}
      <AsPrinted report={report} store={store} />
      <Notes notes={report.notes} store={store} />
    </div>
  );
}

/** That bare numbers stand as the library prints them, where it stores them otherwise. */
function AsPrinted({ report, store }: { report: TranslateReport; store: Store }) {
  const { from, quaternion } = report;
  const library = libraryWith(store.engine, from.library);
  const { printedOrder, arrayOrder } = library ?? {};
  const isBare = quaternion.form.kind === "quaternion" && quaternion.orderSource === "declared";
  if (!library || !printedOrder || !arrayOrder || !isBare || from.order !== printedOrder)
    return null;
  return (
    <ul class="notes">
      <li>{words.asPrinted(library.name, printedOrder, arrayOrder)}</li>
    </ul>
  );
}

function Result({
  report,
  store,
  digits,
}: {
  report: TranslateReport;
  store: Store;
  digits: Digits;
}) {
  const names = namesOf(report, store);
  return (
    <>
      <section class="card translation custom" aria-labelledby="translation-name">
        <h2 id="translation-name">{headline(report)}</h2>
        <div class="translation-numbers">
          {(["from", "to"] as const).map((side) => (
            <div key={side} class={`translation-end ${accentOf(report[side].family)}`}>
              <p class="translation-name">
                {names[side]} <span>{arrowOf(report[side].direction)}</span>
              </p>
              {report[side].numbers ? (
                <NumbersStrip name={names[side]} numbers={report[side].numbers} digits={digits} />
              ) : (
                <ComponentStrip
                  symbol="q"
                  name={words.components(names[side], report[side].order)}
                  components={report[side].components}
                  convention={report[side]}
                  value={endQuaternion(report[side], store.engine.describe)}
                  digits={digits}
                />
              )}
              <CarryLinks
                store={store}
                of={words.components(names[side], report[side].order)}
                quaternion={report[side]}
                to={["read"]}
              />
            </div>
          ))}
        </div>
        {hasNumbers(report) ? (
          <WhyNumbers report={report} names={names} store={store} />
        ) : (
          <Why report={report} names={names} />
        )}
        <LeftHanded report={report} names={names} store={store} />
      </section>
      <div class="columns">
        {(["from", "to"] as const).map((side) => (
          <EndColumn
            key={side}
            side={side}
            name={names[side]}
            end={report[side]}
            isUnit={report.notes.every(({ fact }) => !ofOtherNorm.includes(fact.kind))}
            engine={store.engine}
            digits={digits}
          />
        ))}
      </div>
      <div class="facts">
        {!hasNumbers(report) && <ProductCard report={report} names={names} store={store} />}
        {report.mistakes.length > 0 && (
          <MistakesCard report={report} digits={digits} unit={store.state.value.unit} />
        )}
      </div>
      {report.axes && <AxesCard axes={report.axes} digits={digits} />}
    </>
  );
}

/** What is said of numbers whose norm is not 1. */
const ofOtherNorm: readonly Fact["kind"][] = ["normalised", "far-from-unit"];

/** That only one of the two has left-handed axes, while none are changed. */
function LeftHanded({
  report,
  names,
  store,
}: {
  report: TranslateReport;
  names: EndNames;
  store: Store;
}) {
  const isLeft = (side: "from" | "to") =>
    libraryWith(store.engine, report[side].library)?.axes?.startsWith(leftHanded);
  if (report.axes || Boolean(isLeft("from")) === Boolean(isLeft("to"))) return null;
  return <p class="why">{words.oneIsLeftHanded(isLeft("from") ? names.from : names.to)}</p>;
}

/** How the axes of a record begin that are left-handed. */
const leftHanded = "left-handed";

/** Whether an end has no quaternion. */
const hasNumbers = ({ from, to }: TranslateReport) => Boolean(from.numbers ?? to.numbers);

/** What an end reads again. */
const numbersOf = ({ numbers, array }: TranslatedEnd) => numbers?.values ?? array;

/** What is done to the numbers. */
function headline(report: TranslateReport): string {
  return hasNumbers(report) ? words.numbersChange(report) : words.changeWords(report);
}

/** What the ends of a report are called, which are not those of the state while a text has a problem. */
function namesOf(report: TranslateReport, store: Store): EndNames {
  const { engine } = store;
  const nameOf = (side: "from" | "to") => {
    const { library, convention } = report[side];
    return library === undefined
      ? (conventionName(convention, engine) ?? words.yours)
      : endName({ kind: "library", id: library }, engine);
  };
  const [from, to] = [nameOf("from"), nameOf("to")];
  return from === to ? words.sameNames(from) : { from, to };
}

/** What a screen reader hears when the result changes. */
export function spokenTranslation(store: Store): string {
  const report = store.translate.value?.report;
  if (report === undefined) return "";
  const { digits } = store.state.value;
  const { components, numbers } = report.to;
  const spoken = numbers
    ? namedNumbers(numbers).map(({ name, value }) => `${name} ${shown(value, digits)}`)
    : namesInOrder(report.to).map((name) => `${name} ${shown(components[name], digits)}`);
  return words.spoken(namesOf(report, store).to, spoken, headline(report));
}
