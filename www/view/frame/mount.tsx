// Puts the program into the page, which shows the opening example already, and hands it what was typed
// meanwhile.
import { hydrate, render } from "preact";
import { typeAgain, typedInto } from "../../dom/typed.ts";
import { chosenFormat } from "../../state/copy_format.ts";
import { theme } from "../../state/settings.ts";
import type { Store } from "../../state/store.ts";
import { Page } from "./Page.tsx";
import "./starting.css";

export function mount(store: Store, root: HTMLElement) {
  const { dataset } = document.documentElement;
  const showedExample = dataset["case"] === undefined && root.childElementCount > 0;
  const typed = showedExample ? typedInto(root) : [];
  if (showedExample && isAsAtFirst()) hydrate(<Page store={store} />, root);
  else {
    root.replaceChildren();
    render(<Page store={store} />, root);
  }
  document.querySelector("[data-starting]")?.remove();
  delete dataset["case"];
  delete dataset["waiting"];
  typeAgain(typed, root);
}

/** Whether all is named as for who was never here: attributes that differ would stay. */
const isAsAtFirst = () => theme.peek() === "system" && chosenFormat() === "numbers";
