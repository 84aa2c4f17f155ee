// The way on from the answer: a translation that begins with the library, or with what it follows.
import type { Endpoint, IdentifyReport, Library } from "../../engine.ts";
import { settledConvention } from "../../model/behaviour.ts";
import { translatedFrom } from "../../model/carried.ts";
import type { Store } from "../../state/store.ts";
import * as words from "../../words/identify/answer.tsx";
import { libraryWith } from "../parts/library.ts";
import "../parts/carry_links.css";

/** Nothing until it is settled how four of its numbers are to be read. */
export function TranslateFrom({ store, report }: { store: Store; report: IdentifyReport }) {
  const convention = settledConvention(report.remaining);
  if (convention === undefined) return null;
  const name = store.state.value.libraryName.trim().toLowerCase();
  const library = agreeing(store, report, name);
  return (
    <p class="carry-links">
      {library && (
        <a href={store.linkTo(translatedFrom(endOf(library, store, report)))}>
          {library.name.toLowerCase() === name
            ? words.translateFrom(library.name)
            : words.translateAs(library.name)}
        </a>
      )}
      <a href={store.linkTo(translatedFrom({ kind: "convention", convention }))}>
        {words.translateFromConvention}
      </a>
    </p>
  );
}

/** The record of that name if it matches, or else the first that establishes everything and agrees. */
function agreeing({ engine }: Store, report: IdentifyReport, name: string): Library | undefined {
  const matching = report.libraries.flatMap((match) => {
    const library = libraryWith(engine, match.id);
    return library ? [{ library, isWhole: match.unestablished.length === 0 }] : [];
  });
  const named = matching.find(({ library }) => library.name.toLowerCase() === name);
  return (named ?? matching.find(({ isWhole }) => isWhole))?.library;
}

/** With the direction that was observed, where it is not that of the record. */
function endOf({ id }: Library, { engine }: Store, report: IdentifyReport): Endpoint {
  const [direction, ...others] = report.remaining.direction;
  const usual = engine.describeLibrary(id)?.direction;
  const isOther = direction !== undefined && others.length === 0 && direction !== usual;
  return { kind: "library", id, ...(isOther && { direction }) };
}
