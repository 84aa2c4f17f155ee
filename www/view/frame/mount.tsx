// Puts the program into the page, which shows the opening example already, and does again what was done with it
// meanwhile.
import { hydrate, render } from "preact";
import { read } from "../../action/read_on.ts";
import { doAgain, doneMeanwhile } from "../../dom/meanwhile.ts";
import { chosenFormat } from "../../state/copy_format.ts";
import { theme } from "../../state/settings.ts";
import type { Store } from "../../state/store.ts";
import { Page } from "./Page.tsx";
import "./starting.css";

export function mount(store: Store, root: HTMLElement) {
  const { dataset } = document.documentElement;
  const showedExample = dataset["case"] === undefined && root.childElementCount > 0;
  const meanwhile = showedExample ? doneMeanwhile(root) : undefined;
  const focusedTab = document.activeElement?.getAttribute("data-tab");
  if (showedExample && isAsAtFirst()) hydrate(<Page store={store} />, root);
  else {
    root.replaceChildren();
    render(<Page store={store} />, root);
  }
  document.querySelector("[data-starting]")?.remove();
  for (const mark of ["case", "waiting", "format"]) delete dataset[mark];
  if (focusedTab) root.querySelector<HTMLElement>(`[data-tab="${focusedTab}"]`)?.focus();
  if (meanwhile) doAgain(meanwhile, root, () => read(store));
}

/** Whether all is named as for who was never here: attributes that differ would stay. */
const isAsAtFirst = () => theme.peek() === "system" && chosenFormat() === "numbers";
