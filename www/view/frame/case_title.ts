// What the page shows, in the words of a title, and its address. Loaded after the first result, and with sharing.
import { versionedFragment } from "../../address/fragment.ts";
import { composeTitle, motionTitle, readTitle, translateTitle } from "../../copy/title.ts";
import type { Endpoint, FramesReport } from "../../engine.ts";
import type { Shown, Store } from "../../state/store.ts";
import { citeWords } from "../../words/copy/citation.ts";
import { titleWords as words } from "../../words/copy/title.ts";
import { viewNames } from "../../words/frame/page.tsx";
import { nameOf } from "../parts/convention_names.ts";

/** The title of the page; without a case, as where a text has a problem, the name of the view. */
export function caseTitle(store: Store): string {
  return words.page(caseWords(store) ?? viewNames[store.state.value.view]);
}

function caseWords(store: Store): string | undefined {
  const { engine, state } = store;
  const { view, from, to, libraryName, library } = state.value;
  switch (view) {
    case "read":
      return current(store.read.value, (report) => readTitle(report, engine));
    case "compose":
      return current(store.compose.value, (report) => composeTitle(report, engine));
    case "translate":
      return current(store.translate.value, (report) =>
        translateTitle(report, { from: endNameOf(from, store), to: endNameOf(to, store) }),
      );
    case "motion":
      return current(store.motion.value, (report) => motionTitle(report, engine));
    case "frames":
      return current(store.frames.value, framesTitle);
    case "identify":
      return named(libraryName.trim());
    case "libraries":
      return named(engine.libraries.find(({ id }) => id === library)?.name ?? "");
  }
  function named(name: string) {
    return name === "" ? undefined : words.part(name, viewNames[view]);
  }
}

function framesTitle({ frames, path }: FramesReport): string {
  const child = frames[path.at(-1)?.frame ?? 0]?.name ?? "";
  return words.part(`${child} in ${frames[0]?.name}`, viewNames.frames);
}

/** The address of what is shown, always with its version; a link of a newer quatlas stays what it is. */
export function sharedAddress({ addressed, isLinkNewer }: Store): string {
  if (isLinkNewer.value) return location.href;
  return `${location.href.split("#")[0]}#${versionedFragment(addressed.value)}`;
}

/** What is said of a result that is of the texts as they are now. */
export function current<Report>(
  shown: Shown<Report> | undefined,
  say: (report: Report) => string | undefined,
): string | undefined {
  return shown?.freshness === "current" ? say(shown.report) : undefined;
}

/** The name of a library or of a convention. */
export function endNameOf(end: Endpoint, { engine }: Store): string {
  if (end.kind === "convention") {
    return nameOf(end.convention, engine) ?? citeWords.convention(end.convention);
  }
  return engine.libraries.find(({ id }) => id === end.id)?.name ?? end.id;
}
