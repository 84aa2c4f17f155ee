// The Libraries view: what each library means by four numbers; a reference to link to.
import { useEffect, useId } from "preact/hooks";
import { toFragment } from "../../address/fragment.ts";
import type { Group, Known, Library } from "../../engine.ts";
import type { Store } from "../../state/store.ts";
import { lettersOf } from "../../words/conventions.ts";
import * as words from "../../words/libraries/libraries.tsx";
import {
  familyWords,
  groupNames,
  knownWords,
  notEstablished,
  productWords,
} from "../../words/library_behaviour.ts";
import { aboutLibrary, accentOf, establishedOf, groups, ordersOf } from "../parts/library.ts";
import { found } from "../parts/library_search.ts";
import { LibraryRecord } from "./Record.tsx";
import "../parts/ask.css";
import "../parts/result.css";
import "./libraries.css";

const columns = words.columns;

export function Libraries({ store }: { store: Store }) {
  const { find, library: opened } = store.state.value;
  const { libraries } = store.engine;
  const matching = foundIn(store);
  const inputId = useId();
  useEffect(() => bringIntoView(opened), [opened]);
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
          />
        </div>
        <p class="library-intro">
          {counted(matching, libraries)} {words.legend}
        </p>
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
          <table class="libraries">
            <thead>
              <tr>
                {columns.map((name) => (
                  <th key={name} scope="col">
                    {name}
                  </th>
                ))}
              </tr>
            </thead>
            {groups.map((group) => (
              <GroupRows
                key={group}
                group={group}
                libraries={matching.filter((library) => library.group === group)}
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

function GroupRows({
  group,
  libraries,
  store,
}: {
  group: Group;
  libraries: readonly Library[];
  store: Store;
}) {
  if (libraries.length === 0) return null;
  const { library: opened } = store.state.value;
  return (
    <tbody>
      <tr class="library-group">
        <th scope="rowgroup" colSpan={columns.length}>
          <h2>{groupNames[group]}</h2>
        </th>
      </tr>
      {libraries.flatMap((library) => {
        const isOpen = library.id === opened;
        const row = <Row key={library.id} library={library} isOpen={isOpen} store={store} />;
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

function Row({ library, isOpen, store }: { library: Library; isOpen: boolean; store: Store }) {
  const { family, first } = establishedOf(store.engine.describeLibrary(library.id));
  const toggled = { ...store.state.value, library: isOpen ? "" : library.id };
  const { arrayOrder, handedness, matrix, vectors } = library;
  const constructed = library.constructorOrder && lettersOf[library.constructorOrder];
  const isOther = ordersOf(library).length === 2;
  const cells = [
    library.version,
    knownWords[library.known][0],
    arrayOrder && lettersOf[arrayOrder],
    isOther ? <strong>{constructed}</strong> : constructed,
    handedness && productWords[handedness],
    library.rotate && `${library.rotate}(q)`,
    matrix && `${matrix}(q)${vectors === undefined ? "" : vectors === "row" ? ", v M" : ", M v"}`,
    first && (first === "right" ? "b" : "a"),
    family && <span class={`family ${accentOf(family)}`}>{familyWords[family][0]}</span>,
  ];
  return (
    <tr id={rowId(library.id)} class={isOpen ? "library-row open" : "library-row"}>
      <th scope="row">
        <a href={`#${toFragment(toggled)}`} aria-expanded={isOpen}>
          {library.name}
        </a>
      </th>
      {cells.map((cell, at) => (
        <td key={columns[at + 1]} data-label={columns[at + 1]}>
          {cell ?? <NotEstablished />}
        </td>
      ))}
    </tr>
  );
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
