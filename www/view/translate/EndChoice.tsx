// One end of a translation: a library or a convention, and what is said of its numbers beyond that.
import { useId, useState } from "preact/hooks";
import { toFragment } from "../../address/fragment.ts";
import type { ComponentOrder, Convention, Direction, Endpoint, Library } from "../../engine.ts";
import { type Axis, axes } from "../../model/conventions.ts";
import type { Store } from "../../state/store.ts";
import { directionValues, namedConventions } from "../../values.ts";
import { arrowOf, lettersOf } from "../../words/conventions.ts";
import { knownWords } from "../../words/library_behaviour.ts";
import * as words from "../../words/translate/end_choice.ts";
import { AxisChoice } from "../parts/AxisChoice.tsx";
import { Choice } from "../parts/Choice.tsx";
import { fiveWords } from "../parts/convention_names.ts";
import { libraryWith, ordersOf } from "../parts/library.ts";
import { type Convened, LibraryPicker } from "./LibraryPicker.tsx";
import "../parts/axes_panel.css";
import "./end_choice.css";
import "./segments.css";

type LibraryEnd = Extract<Endpoint, { kind: "library" }>;

export function EndChoice({ store, side }: { store: Store; side: "from" | "to" }) {
  const { engine } = store;
  const end = store.state.value[side];
  const [isCustom, setCustom] = useState(false);
  const library = end.kind === "library" ? libraryWith(engine, end.id) : undefined;
  const set = (changed: Endpoint) => store.set({ [side]: changed });
  const convene = (kind: Convened) => {
    setCustom(kind === "custom");
    // One's own convention starts from what stands here.
    const now =
      end.kind === "convention"
        ? end.convention
        : (engine.describeLibrary(end.id)?.convention ?? namedConventions.hamilton);
    const convention = kind === "custom" ? now : namedConventions[kind];
    set({ kind: "convention", convention });
  };
  return (
    <fieldset class="end" aria-label={words.side[side]}>
      <LibraryPicker
        engine={engine}
        label={words.side[side]}
        end={end}
        choose={(id) => set({ kind: "library", id })}
        convene={convene}
      />
      {library && end.kind === "library" && (
        <>
          <p class="end-known">
            {library.version} · {knownWords[library.known][0]} ·{" "}
            <a
              href={`#${toFragment({ ...store.state.value, view: "libraries", library: library.id, find: "" })}`}
            >
              {words.record}
            </a>
          </p>
          <div class="end-choices">
            <DirectionChoice store={store} end={end} library={library} set={set} />
            {library.numbers === undefined && <OrderChoice end={end} library={library} set={set} />}
          </div>
        </>
      )}
      {end.kind === "convention" && (
        <FiveAxes
          convention={end.convention}
          side={side}
          isOpen={isCustom}
          set={(convention) => set({ kind: "convention", convention })}
        />
      )}
    </fieldset>
  );
}

/** A library as an end; what is as in its record is left out. */
function libraryEnd(
  id: string,
  order: ComponentOrder | undefined,
  direction: Direction | undefined,
): LibraryEnd {
  return {
    kind: "library",
    id,
    ...(order !== undefined && { order }),
    ...(direction !== undefined && { direction }),
  };
}

function DirectionChoice({
  store,
  end,
  library,
  set,
}: {
  store: Store;
  end: LibraryEnd;
  library: Library;
  set: (end: Endpoint) => void;
}) {
  const group = useId();
  const usual = store.engine.describeLibrary(end.id);
  if (usual === undefined) return null;
  const reason = (direction: Direction): string | undefined => {
    if (direction !== usual.direction) return undefined;
    if (library.direction !== undefined) return words.documented;
    return usual.assumed.includes("action") ? words.assumed : words.customary;
  };
  return (
    <Choice
      kind="segments"
      group={group}
      legend={library.numbers ? words.numbersTake : words.takes(usual.action)}
      values={directionValues.map((direction) => ({
        value: direction,
        words: <Noted word={arrowOf(direction)} note={reason(direction)} />,
      }))}
      chosen={end.direction ?? usual.direction}
      choose={(direction) =>
        set(libraryEnd(end.id, end.order, direction === usual.direction ? undefined : direction))
      }
    />
  );
}

/** Where what is printed, an array and a constructor differ, or none is known, people say which they mean. */
function OrderChoice({
  end,
  library,
  set,
}: {
  end: LibraryEnd;
  library: Library;
  set: (end: Endpoint) => void;
}) {
  const group = useId();
  const orders = ordersOf(library);
  if (orders.length === 1 && (end.order === undefined || end.order === orders[0])) return null;
  const usual = orders[0] ?? "scalar-last";
  const reason = (order: string): string | undefined => {
    if (orders.length === 0) return order === usual ? words.assumed : undefined;
    if (order === library.printedOrder) return words.printed;
    if (order === library.arrayOrder) return words.ofArray;
    return order === library.constructorOrder ? words.ofConstructor : undefined;
  };
  return (
    <Choice
      kind="segments"
      group={group}
      legend={words.order}
      values={(["scalar-last", "scalar-first"] as const).map((order) => ({
        value: order,
        words: <Noted word={lettersOf[order]} note={reason(order)} />,
      }))}
      chosen={end.order ?? usual}
      choose={(order) =>
        set(libraryEnd(end.id, order === usual ? undefined : order, end.direction))
      }
    />
  );
}

/** A value, and why it is the usual one or what it is for. */
function Noted({ word, note }: { word: string; note: string | undefined }) {
  return (
    <>
      <span>{word}</span> {note !== undefined && <span class="segment-note">{note}</span>}
    </>
  );
}

function FiveAxes({
  convention,
  side,
  isOpen,
  set,
}: {
  convention: Convention;
  side: "from" | "to";
  isOpen: boolean;
  set: (convention: Convention) => void;
}) {
  return (
    <details class="end-five" open={isOpen}>
      <summary>
        {words.five} <span class="more-now">{fiveWords(convention)}</span>
      </summary>
      <div class="axis-choices">
        {axes.map((axis: Axis) => (
          <AxisChoice
            key={axis}
            axis={axis}
            group={`${side}-${axis}`}
            chosen={convention[axis]}
            choose={(value) => set({ ...convention, [axis]: value } as Convention)}
          />
        ))}
      </div>
    </details>
  );
}
