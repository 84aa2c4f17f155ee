// The Libraries view: what each library means by four numbers; a reference to link to.
import type { ComponentChildren } from "preact";
import { useEffect, useId, useRef, useState } from "preact/hooks";
import { toFragment } from "../../address/fragment.ts";
import type { Group, Known, Library, RecordNumbers } from "../../engine.ts";
import type { Store } from "../../state/store.ts";
import { lettersOf } from "../../words/conventions.ts";
import * as words from "../../words/libraries/libraries.tsx";
import {
  familyWords,
  groupNames,
  hasShortNames,
  inUnit,
  kindNames,
  knownWords,
  libraryKind,
  meansWords,
  notEstablished,
  numbersCalled,
  numbersNames,
  productWords,
} from "../../words/library_behaviour.ts";
import { aboutLibrary, accentOf, establishedOf, groups, ordersOf } from "../parts/library.ts";
import { found } from "../parts/library_search.ts";
import { placeAfter } from "../parts/roving.ts";
import { LibraryRecord } from "./Record.tsx";
import "../parts/ask.css";
import "../parts/result.css";
import "./libraries.css";

const columnOf = words.columns;
const columns = Object.values(columnOf);

export function Libraries({ store }: { store: Store }) {
  const { find, library: opened } = store.state.value;
  const { libraries } = store.engine;
  const matching = foundIn(store);
  const inputId = useId();
  const table = useRef<HTMLTableElement>(null);
  const links = () => [...(table.current?.querySelectorAll<HTMLElement>(".library-row a") ?? [])];
  // The list is one stop of the Tab key: the library that had the focus, or was opened, last.
  const [last, setLast] = useState("");
  const grouped = groups.map((group) => ({
    group,
    members: matching.filter((library) => library.group === group),
  }));
  const ids = grouped.flatMap(({ members }) => members.map(({ id }) => id));
  const stop = ids.includes(last) ? last : ids[0];
  useEffect(() => {
    bringIntoView(opened);
    setLast((last) => opened || last);
  }, [opened]);
  return (
    <>
      <section class="ask library-ask" aria-label={words.input}>
        <h2 class="visually-hidden">{words.title}</h2>
        <div class="library-find">
          <label for={inputId}>{words.find}</label>
          <input
            id={inputId}
            type="search"
            autocomplete="off"
            spellcheck={false}
            placeholder={words.findExample}
            value={find}
            onInput={(event) => store.set({ find: event.currentTarget.value })}
            onKeyDown={(event) => {
              if (event.key !== "ArrowDown") return;
              event.preventDefault();
              links()
                .find((link) => link.tabIndex === 0)
                ?.focus();
            }}
          />
        </div>
        <p class="library-intro">
          {counted(matching, libraries)} {words.matrices}{" "}
          <span class="of-columns">{words.actsFirst}</span>{" "}
          <span class="of-lines">{words.constructorInBold}</span> {words.dash}
        </p>
        <nav class="library-groups" aria-label={words.groups}>
          {grouped.map(({ group, members }) => (
            <button
              key={group}
              type="button"
              disabled={members.length === 0}
              onClick={() => goToGroup(group)}
            >
              {groupNames[group]}
            </button>
          ))}
        </nav>
      </section>
      <div class="result current">
        {matching.length === 0 ? (
          <p class="absent">
            {words.none}{" "}
            <button type="button" class="quiet" onClick={() => store.set({ find: "" })}>
              {words.showAll(libraries.length)}
            </button>
          </p>
        ) : (
          <table
            ref={table}
            class="libraries"
            onKeyDown={(event) => {
              const rows = links();
              const at = rows.indexOf(event.target as HTMLElement);
              if (at < 0) return;
              const next = placeAfter(event, at, { count: rows.length, columns: rows.length });
              if (next === undefined) return;
              event.preventDefault();
              rows[next]?.focus();
            }}
          >
            <thead>
              <tr>
                {columns.map((name) => (
                  <th key={name} scope="col">
                    {name}
                  </th>
                ))}
              </tr>
            </thead>
            {grouped.map(({ group, members }) => (
              <GroupRows
                key={group}
                group={group}
                libraries={members}
                stop={stop}
                onFocus={setLast}
                store={store}
              />
            ))}
          </table>
        )}
      </div>
    </>
  );
}

function foundIn(store: Store): readonly Library[] {
  const { engine } = store;
  const { find } = store.state.value;
  return found(engine.libraries, find, (library) => aboutLibrary(library, engine));
}

const groupId = (group: Group) => `libraries-${group}`;

/** Its heading comes to the top, and its first library has the focus. */
function goToGroup(group: Group) {
  const heading = document.getElementById(groupId(group));
  heading?.scrollIntoView({ block: "start" });
  heading?.parentElement?.querySelector("a")?.focus({ preventScroll: true });
}

const rowId = (id: string) => `library-${id}`;

/** A record that was opened by its address is somewhere below. */
function bringIntoView(id: string) {
  const row = document.getElementById(rowId(id));
  if (row === null) return;
  const { top, bottom } = row.getBoundingClientRect();
  if (top < 0 || bottom > innerHeight) row.scrollIntoView({ block: "start" });
}

function counted(matching: readonly Library[], all: readonly Library[]): string {
  const of = (known: Known) => matching.filter((library) => library.known === known).length;
  const known = (["run", "read", "documented"] as const)
    .map((how) => [how, of(how)] as const)
    .filter(([, count]) => count > 0);
  return words.counted(matching.length, all.length, known);
}

/** The library that the Tab key reaches, and what is done when one has the focus. */
interface Stop {
  stop: string | undefined;
  onFocus: (id: string) => void;
}

function GroupRows({
  group,
  libraries,
  store,
  ...stop
}: Stop & {
  group: Group;
  libraries: readonly Library[];
  store: Store;
}) {
  if (libraries.length === 0) return null;
  const { library: opened } = store.state.value;
  return (
    <tbody>
      <tr id={groupId(group)} class="library-group">
        <th scope="rowgroup" colSpan={columns.length}>
          <h2>{groupNames[group]}</h2>
        </th>
      </tr>
      {libraries.flatMap((library) => {
        const isOpen = library.id === opened;
        const row = (
          <Row key={library.id} library={library} isOpen={isOpen} store={store} {...stop} />
        );
        if (!isOpen) return [row];
        return [
          row,
          <tr key={`${library.id} record`} class="library-opened">
            <td colSpan={columns.length}>
              <LibraryRecord library={library} store={store} />
            </td>
          </tr>,
        ];
      })}
    </tbody>
  );
}

function Row({
  library,
  isOpen,
  store,
  stop,
  onFocus,
}: Stop & { library: Library; isOpen: boolean; store: Store }) {
  const toggled = { ...store.state.value, library: isOpen ? "" : library.id };
  return (
    <tr id={rowId(library.id)} class={isOpen ? "library-row open" : "library-row"}>
      <th scope="row">
        <a
          href={`#${toFragment(toggled)}`}
          aria-expanded={isOpen}
          tabIndex={library.id === stop ? 0 : -1}
          onFocus={() => onFocus(library.id)}
        >
          {library.name}
        </a>
        {kindOf(library) && <span class="library-kind">{kindOf(library)}</span>}
      </th>
      {cellsOf(library, store).map(({ column, content, line, columns }) => (
        <td
          key={column}
          class={line ? `line-cell line-${line}` : undefined}
          colSpan={columns}
          data-label={column}
        >
          {content ?? <NotEstablished />}
        </td>
      ))}
    </tr>
  );
}

/** What a record is of; libraries have no word but among formats. */
function kindOf({ kind, group }: Library): string | undefined {
  if (kind !== undefined) return kindNames[kind];
  return group === "devices" ? libraryKind : undefined;
}

interface Cell {
  /** The head of its column. */
  column: string;
  /** How many columns it takes, where that is not one. */
  columns?: number;
  content?: ComponentChildren;
  /** Its place in the line that stands for the row on a phone; the others wait for the record. */
  line?: "order" | "other-order" | "product" | "matrix" | "family" | false | undefined;
}

/** What is known of a library, in the order of the columns. */
function cellsOf(library: Library, store: Store): Cell[] {
  const { family, first } = establishedOf(store.engine.describeLibrary(library.id));
  const accent = accentOf(family);
  const { arrayOrder, constructorOrder, handedness, matrix, numbers, rotate, vectors } = library;
  const constructed = constructorOrder && lettersOf[constructorOrder];
  const isOther = ordersOf(library).length === 2;
  const isRotating = rotate !== undefined || matrix === undefined;
  const cells: Cell[] = [
    { column: columnOf.version, content: library.version },
    { column: columnOf.known, content: knownWords[library.known][0] },
    {
      column: columnOf.array,
      content: arrayOrder && lettersOf[arrayOrder],
      line: isOther ? "other-order" : (arrayOrder || !constructorOrder) && "order",
    },
    {
      column: columnOf.constructor,
      content: isOther ? <strong>{constructed}</strong> : constructed,
      line: (isOther || (!arrayOrder && constructorOrder)) && "order",
    },
    {
      column: columnOf.product,
      content: handedness && (
        <span class={`line-accent ${accent}`}>{productWords[handedness]}</span>
      ),
      line: "product",
    },
    { column: columnOf.rotates, content: rotate && `${rotate}(q)`, line: isRotating && "matrix" },
    {
      column: columnOf.matrix,
      content: matrix && (
        <>
          {matrix}(q)
          <span class="matrix-vectors">
            {vectors === undefined ? "" : vectors === "row" ? ", v M" : ", M v"}
          </span>
        </>
      ),
      line: !isRotating && "matrix",
    },
    { column: columnOf.first, content: first && (first === "right" ? "b" : "a") },
    {
      column: columnOf.short,
      content: family && <span class={`family ${accent}`}>{familyWords[family][0]}</span>,
      line: "family",
    },
  ];
  return numbers ? cells.flatMap((cell) => withNumbers(cell, numbers)) : cells;
}

/** Where no quaternion is written: what is, and how it makes the rotation, in the columns of orders and product. */
function withNumbers(cell: Cell, numbers: RecordNumbers): Cell[] {
  switch (cell.column) {
    case columnOf.array: {
      const unit = <span class="numbers-in">{inUnit(numbers.unit)}</span>;
      return [{ ...cell, columns: 2, content: [numbersCalled(numbers), unit] }];
    }
    case columnOf.product: {
      const { means, names } = numbers;
      const product = meansWords(hasShortNames(names) ? numbers : { means, names: undefined });
      return [{ ...cell, columns: 2, content: <code class="numbers-in">{product}</code> }];
    }
    case columnOf.constructor:
    case columnOf.rotates:
      return [];
    case columnOf.matrix:
      return [{ ...cell, line: "matrix" }];
    case columnOf.first:
      return [{ ...cell, content: "" }];
    case columnOf.short:
      return [{ ...cell, content: numbersNames[numbers.kind] }];
    default:
      return [cell];
  }
}

function NotEstablished() {
  return (
    <span class="none" title={notEstablished}>
      <span aria-hidden="true">–</span>
      <span class="visually-hidden">{notEstablished}</span>
    </span>
  );
}

/** What a screen reader hears when the table changes. */
export function spokenLibraries(store: Store): string {
  const matching = foundIn(store);
  const opened = matching.find(({ id }) => id === store.state.value.library);
  return words.spoken(matching.length, store.engine.libraries.length, opened?.name);
}
