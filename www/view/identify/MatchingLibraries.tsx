// The records that say nothing else than what was observed.
import { toFragment } from "../../address/fragment.ts";
import type { IdentifyReport, LibraryMatch } from "../../engine.ts";
import type { Store } from "../../state/store.ts";
import * as words from "../../words/identify/matching_libraries.ts";
import { knownWords } from "../../words/library_behaviour.ts";
import { isLibrary, libraryWith } from "../parts/library.ts";
import "../parts/result.css";
import "./matching_libraries.css";

/** As many are shown without being asked for. */
const shownAtOnce = 12;

/** Stands for the id of any record. */
const anyId = "any-id";

/** A record that leaves more choices open than these hardly tells anything. */
const mostOpen = 2;

export function MatchingLibraries({ store, report }: { store: Store; report: IdentifyReport }) {
  const open = ({ unestablished }: LibraryMatch) => unestablished.length;
  const all = report.libraries;
  const agree = all.filter((match) => open(match) === 0);
  const leaveOpen = all.filter((match) => open(match) > 0 && open(match) <= mostOpen);
  const sayLittle = all.filter((match) => open(match) > mostOpen);
  return (
    <section class="fact matches" aria-labelledby="matches-name">
      <h2 id="matches-name">
        {words.title(all.length, store.engine.libraries.filter(isLibrary).length)}
      </h2>
      {all.length === 0 && <p>{words.none}</p>}
      <MatchList store={store} title={words.agree} matches={agree} />
      <MatchList store={store} title={words.leaveOpen} matches={leaveOpen} />
      {sayLittle.length > 0 && (
        <details class="products">
          <summary>{words.sayLittle(sayLittle.length)}</summary>
          <Matches store={store} matches={sayLittle} />
        </details>
      )}
    </section>
  );
}

function MatchList({
  store,
  title,
  matches,
}: {
  store: Store;
  title: string;
  matches: readonly LibraryMatch[];
}) {
  if (matches.length === 0) return null;
  const more = matches.slice(shownAtOnce);
  return (
    <>
      <h3>
        {title}: {matches.length}
      </h3>
      <Matches store={store} matches={matches.slice(0, shownAtOnce)} />
      {more.length > 0 && (
        <details class="products">
          <summary>{words.more(more.length)}</summary>
          <Matches store={store} matches={more} />
        </details>
      )}
    </>
  );
}

function Matches({ store, matches }: { store: Store; matches: readonly LibraryMatch[] }) {
  // Written once for all of them: an address takes its time.
  const address = toFragment({ ...store.state.value, view: "libraries", library: anyId });
  const linkTo = (id: string) => `#${address.replace(`library=${anyId}`, `library=${id}`)}`;
  return (
    <ul class="match-list">
      {matches.map((match) => (
        <Match key={match.id} store={store} match={match} linkTo={linkTo} />
      ))}
    </ul>
  );
}

function Match({
  store,
  match,
  linkTo,
}: {
  store: Store;
  match: LibraryMatch;
  linkTo: (id: string) => string;
}) {
  const library = libraryWith(store.engine, match.id);
  if (library === undefined) return null;
  return (
    <li>
      <a href={linkTo(library.id)}>{library.name}</a>{" "}
      <span class="match-version">
        {library.version}, {knownWords[library.known][0]}
      </span>
      {match.unestablished.length > 0 && (
        <span class="match-open">{words.unestablished(match.unestablished)}</span>
      )}
    </li>
  );
}
