// One end of a translation: a library or a convention, and what is said of its numbers beyond that.
import type { ComponentChildren } from "preact";
import { useId, useState } from "preact/hooks";
import { type Axis, axes, axisValues, toFragment } from "../address.ts";
import type { ComponentOrder, Convention, Direction, Endpoint, Library } from "../engine.ts";
import type { Store } from "../state.ts";
import { arrowOf, lettersOf } from "../words/conventions.ts";
import { knownWords } from "../words/library_behaviour.ts";
import * as words from "../words/translate_ends.ts";
import { Choice } from "./Axes.tsx";
import { fiveWords } from "./conventions.ts";
import { type Convened, LibraryPicker } from "./LibraryPicker.tsx";
import { libraryWith, ordersOf } from "./library.ts";

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
        : (engine.endOf(end.id)?.convention ?? engine.hamilton);
    const convention = kind === "custom" ? now : engine[kind];
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
            <OrderChoice end={end} library={library} set={set} />
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
  const usual = store.engine.endOf(end.id);
  if (usual === undefined) return null;
  const reason = (direction: Direction): string | undefined => {
    if (direction !== usual.direction) return undefined;
    if (library.direction !== undefined) return words.documented;
    return usual.assumed.includes("action") ? words.assumed : words.customary;
  };
  return (
    <Segments
      legend={words.takes(usual.action)}
      choices={axisValues.direction.map((direction) => ({
        value: direction,
        word: arrowOf(direction),
        note: reason(direction),
      }))}
      chosen={end.direction ?? usual.direction}
      choose={(direction) =>
        set(libraryEnd(end.id, end.order, direction === usual.direction ? undefined : direction))
      }
    />
  );
}

/** Where an array and a constructor differ, or neither is known, people say which they mean. */
function OrderChoice({
  end,
  library,
  set,
}: {
  end: LibraryEnd;
  library: Library;
  set: (end: Endpoint) => void;
}) {
  const orders = ordersOf(library);
  if (orders.length === 1 && (end.order === undefined || end.order === orders[0])) return null;
  const usual = orders[0] ?? "scalar-last";
  const reason = (order: string): string | undefined => {
    if (orders.length === 0) return order === usual ? words.assumed : undefined;
    if (order === library.arrayOrder) return words.ofArray;
    return order === library.constructorOrder ? words.ofConstructor : undefined;
  };
  return (
    <Segments
      legend={words.order}
      choices={(["scalar-last", "scalar-first"] as const).map((order) => ({
        value: order,
        word: lettersOf[order],
        note: reason(order),
      }))}
      chosen={end.order ?? usual}
      choose={(order) =>
        set(libraryEnd(end.id, order === usual ? undefined : order, end.direction))
      }
    />
  );
}

/** A few values beside each other, of which one holds. */
export function Segments<Value extends string>({
  legend,
  choices,
  chosen,
  choose,
}: {
  legend: ComponentChildren;
  choices: readonly { value: Value; word: string; note?: string | undefined }[];
  chosen: Value;
  choose: (value: Value) => void;
}) {
  const group = useId();
  return (
    <fieldset class="segments">
      <legend>{legend}</legend>
      <div>
        {choices.map(({ value, word, note }) => (
          <label key={value}>
            <input
              type="radio"
              name={group}
              value={value}
              checked={value === chosen}
              onChange={() => choose(value)}
            />
            <span>{word}</span> {note !== undefined && <span class="segment-note">{note}</span>}
          </label>
        ))}
      </div>
    </fieldset>
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
          <Choice
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
