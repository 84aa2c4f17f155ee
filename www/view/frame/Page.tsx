// The frame of the page: name, views, the view itself, and what is said aloud.
import type { VNode } from "preact";
import { version } from "../../../package.json";
import type { Digits, Unit, View } from "../../model/page_state.ts";
import { repositoryLinks } from "../../model/repository.ts";
import { shownAngle, shownAxis } from "../../number/format.ts";
import type { Store } from "../../state/store.ts";
import { symbolOf } from "../../words/conventions.ts";
import * as words from "../../words/frame/page.tsx";
import { spokenStops } from "../parts/Notes.tsx";
import { Read } from "../read/Read.tsx";
import { Announcements } from "./Announcements.tsx";
import { Lazy } from "./Lazy.tsx";
import { isLazy, loadingOf } from "./lazy_views.ts";
import { Overlay } from "./Overlay.tsx";
import { NewerLink, Share, Version } from "./Share.tsx";
import { Parts, Tabs } from "./Tabs.tsx";
import { Tools } from "./Tools.tsx";
import { shownCase, useCaseTitle } from "./title.ts";
import "./page.css";

export function Page({ store }: { store: Store }) {
  const state = store.state.value;
  const failure = store.failure.value;
  useCaseTitle(store);
  return (
    <>
      <button type="button" class="skip" onClick={() => focusResult()}>
        {words.skip}
      </button>
      <header class="masthead">
        <h1 class="wordmark">{words.name}</h1>
        <p class="tagline">{words.tagline}</p>
        <Tabs store={store} />
        <Tools>
          <Share store={store} />
        </Tools>
      </header>
      <main>
        <Parts store={store} />
        <NewerLink store={store} />
        {failure !== undefined && (
          <p class="failure" role="alert">
            {words.failure(failure)}
          </p>
        )}
        <Shown key={state.view} view={state.view} store={store} />
      </main>
      <Colophon />
      <Announcements result={spoken(store)} of={state} />
      <Overlay store={store} />
    </>
  );
}

/** Set where the page is built. */
declare const repositoryAddress: string | undefined;

function Colophon() {
  return (
    <footer class="colophon">
      <p>
        {words.colophon} <Version />{" "}
        {repositoryLinks(repositoryAddress).map(({ name, href }) => (
          <>
            <a href={href}>{words.repositoryLinks[name]}</a>{" "}
          </>
        ))}
        <a href="./licences.txt">{words.licences}</a>
      </p>
      <PrintedCase />
    </footer>
  );
}

/** On paper only: what was printed, as a link, and the address for who has the paper alone. */
function PrintedCase() {
  const shown = shownCase.value;
  if (shown === undefined) return null;
  return (
    <p class="printed-case">
      <a href={shown.address}>{shown.title}</a> {version}
      <br />
      {shown.address}
    </p>
  );
}

/** Past the fields and examples, to the numbers. */
function focusResult() {
  const result =
    document.querySelector<HTMLElement>("main .result") ?? document.querySelector("main");
  if (result === null) return;
  result.tabIndex = -1;
  result.focus();
}

function Shown({ view, store }: { view: View; store: Store }): VNode {
  if (isLazy(view)) return <Lazy view={view} name={words.viewNames[view]} store={store} />;
  return <Read store={store} />;
}

/** What a screen reader hears when the result changes. */
function spoken(store: Store): string {
  const problems = store.problems.value.map((problem) =>
    words.spokenProblem(symbolOf[problem.field], problem),
  );
  if (problems.length > 0) return problems.join(" ");
  return [...spokenStops(store), spokenResult(store)].join(" ");
}

function spokenResult(store: Store): string {
  const { view, digits, unit } = store.state.value;
  switch (view) {
    case "read":
      return spokenTurn(store, digits, unit);
    default: {
      const loading = loadingOf[view].value;
      return loading.status === "loaded" ? loading.spoken(store) : "";
    }
  }
}

function spokenTurn(store: Store, digits: Digits, unit: Unit): string {
  const turn = store.read.value?.report.turn;
  if (turn === undefined) return "";
  if (turn.axis === undefined) return words.spokenNoTurn;
  const angle = { degrees: turn.angleDeg, radians: turn.angleRad };
  return words.spokenTurn(shownAngle(angle, digits, unit), shownAxis(turn.axis, digits));
}
