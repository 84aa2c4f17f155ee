// The frame of the page: name, views, the view itself, and what is said aloud.
import type { VNode } from "preact";

import { type Digits, toFragment, type Unit, type View } from "../address.ts";
import { shown, shownAngle, shownAxis } from "../format.ts";

import { saidOf } from "../said.ts";

import type { Store } from "../state.ts";
import { Compose } from "./Compose.tsx";
import { Identify, spokenIdentity } from "./Identify.tsx";
import { Libraries, spokenLibraries } from "./Libraries.tsx";
import { Overlay } from "./Overlay.tsx";
import { Read } from "./Read.tsx";
import { Tools } from "./Settings.tsx";
import { NewerLink, Share, Version } from "./Share.tsx";
import { spokenTranslation, Translate } from "./Translate.tsx";
import { namesInOrder } from "./Value.tsx";
import { nameOf, symbolOf } from "./words.ts";

const views: { view: View; name: string; Shown: (props: { store: Store }) => VNode }[] = [
  { view: "read", name: "Read", Shown: Read },
  { view: "compose", name: "Compose", Shown: Compose },
  { view: "translate", name: "Translate", Shown: Translate },
  { view: "identify", name: "Identify", Shown: Identify },
  { view: "libraries", name: "Libraries", Shown: Libraries },
];

export function Page({ store }: { store: Store }) {
  const state = store.state.value;
  const failure = store.failure.value;
  return (
    <>
      <header class="masthead">
        <h1 class="wordmark">quatlas</h1>
        <p class="tagline">One rotation, every convention.</p>
        <nav class="views" aria-label="Views">
          {views.map(({ view, name }) => (
            <a
              key={view}
              href={`#${toFragment({ ...state, view })}`}
              aria-current={state.view === view ? "page" : undefined}
            >
              {name}
            </a>
          ))}
        </nav>
        <Share store={store} />
        <Tools />
      </header>
      <main>
        <NewerLink store={store} />
        {failure !== undefined && (
          <p class="failure" role="alert">
            The core stopped on this input, which is a mistake in quatlas, not in your text:{" "}
            <code>{failure}</code>. The last good result stays below; go on with another text, or
            reload the page.
          </p>
        )}
        {views.map(({ view, Shown }) => view === state.view && <Shown key={view} store={store} />)}
      </main>
      <footer class="colophon">
        <p>
          Computed in your browser; nothing you type is sent anywhere. The address of the page holds
          what you typed: share it as a link. <Version />
        </p>
      </footer>
      <p class="visually-hidden" role="status" aria-live="polite">
        {[saidOf(state), spoken(store)].join(" ").trim()}
      </p>
      <Overlay store={store} />
    </>
  );
}

/** What a screen reader hears when the result changes. */
function spoken(store: Store): string {
  const { view, digits, unit } = store.state.value;
  const problems = store.problems.value.map(
    ({ field, message, expected, hint }) =>
      `Problem in ${symbolOf[field]}: ${message}. Expected ${expected}. Try ${hint}.`,
  );
  if (problems.length > 0) return problems.join(" ");
  switch (view) {
    case "read":
      return spokenTurn(store, digits, unit);
    case "compose":
      return spokenProduct(store, digits);
    case "translate":
      return spokenTranslation(store);
    case "identify":
      return spokenIdentity(store);
    case "libraries":
      return spokenLibraries(store);
  }
}

function spokenProduct(store: Store, digits: Digits): string {
  const product = store.compose.value?.report.declared;
  if (product === undefined) return "";
  const { convention, quaternion } = product;
  const numbers = namesInOrder(convention).map(
    (name) => `${name} ${shown(quaternion[name], digits)}`,
  );
  const name = nameOf(convention, store.engine) ?? "your convention";
  return `Result: p times q in ${name}: ${numbers.join(", ")}.`;
}

function spokenTurn(store: Store, digits: Digits, unit: Unit): string {
  const turn = store.read.value?.report.turn;
  if (turn === undefined) return "";
  if (turn.axis === undefined) return "Result: no turn.";
  const angle = { degrees: turn.angleDeg, radians: turn.angleRad };
  return `Result: a turn by ${shownAngle(angle, digits, unit)} about ${shownAxis(turn.axis, digits)}.`;
}
