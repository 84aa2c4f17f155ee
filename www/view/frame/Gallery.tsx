// Every example with what it teaches, each a link.
import { useMemo } from "preact/hooks";
import { toFragment } from "../../address/fragment.ts";
import { stateOf } from "../../model/examples/example.ts";
import { exampleNames, exampleOf } from "../../model/examples/gallery.ts";
import { type PageState, views } from "../../model/page_state.ts";
import type { Store } from "../../state/store.ts";
import { exampleWords, groupWords } from "../../words/examples/gallery.ts";
import "./gallery.css";

export function Gallery({ store, hide }: { store: Store; hide: () => void }) {
  const state = store.state.value;
  // The random one stays as it is while the gallery is open.
  const examples = useMemo(() => exampleNames.map((name) => ({ name, ...exampleOf(name) })), []);
  const groups = views
    .map((view) => ({ view, shown: examples.filter((example) => example.view === view) }))
    .filter(({ shown }) => shown.length > 0);
  const leave = () => {
    hide();
    scrollTo({ top: 0 });
  };
  return groups.map(({ view, shown }) => (
    <section key={view} class="gallery-group" aria-labelledby={`gallery-${view}`}>
      <h3 id={`gallery-${view}`}>{groupWords[view]}</h3>
      <ul class="gallery">
        {shown.map((example) => {
          const [title, teaches] = exampleWords[example.name];
          return (
            <li key={example.name}>
              <a href={linkTo(stateOf(example, state))} onClick={leave}>
                {title}
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
