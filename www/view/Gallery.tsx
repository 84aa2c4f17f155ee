// Every example with what it teaches, each a link.
import { type PageState, toFragment, views } from "../address.ts";
import { stateOf } from "../examples.ts";
import { exampleNames, gallery } from "../gallery.ts";
import type { Store } from "../state.ts";
import { exampleWords, groupWords } from "../words/gallery.ts";
import { hideOverlay } from "./Overlay.tsx";

export function Gallery({ store }: { store: Store }) {
  const state = store.state.value;
  const groups = views
    .map((view) => ({ view, names: exampleNames.filter((name) => gallery[name].view === view) }))
    .filter(({ names }) => names.length > 0);
  const leave = () => {
    hideOverlay();
    scrollTo({ top: 0 });
  };
  return groups.map(({ view, names }) => (
    <section key={view} class="gallery-group" aria-labelledby={`gallery-${view}`}>
      <h3 id={`gallery-${view}`}>{groupWords[view]}</h3>
      <ul class="gallery">
        {names.map((example) => {
          const [name, teaches] = exampleWords[example];
          return (
            <li key={example}>
              <a href={linkTo(stateOf(gallery[example], state))} onClick={leave}>
                {name}
              </a>
              <p>{teaches}</p>
            </li>
          );
        })}
      </ul>
    </section>
  ));
}

/** In full: a short one, scrolled out of the dialog, would be taken for a link that skips content. */
function linkTo(state: PageState): string {
  return new URL(`#${toFragment(state)}`, location.href).href;
}
