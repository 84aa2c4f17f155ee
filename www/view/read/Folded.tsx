// What few ask for, folded: a line each, and what they hold comes after the first result.
import { waits } from "../../words/parts/later.ts";
import * as words from "../../words/read/folded.ts";
import { AskedFold } from "../parts/AskedFold.tsx";
import { useLater } from "../parts/later.ts";
import type { Given } from "./FoldedBody.tsx";
import "../parts/fold.css";

const loadAtlas = () => import("./Atlas.tsx").then(({ Atlas }) => Atlas);
const loadBody = () => import("./FoldedBody.tsx").then(({ FoldedBody }) => FoldedBody);

export function Folded(given: Given) {
  const Body = useLater(loadBody);
  const isTwisted = given.store.state.value.open.includes("swing-twist");
  return (
    <section class="folds" aria-label={words.more}>
      {words.parts.map((part) => (
        <details key={part} class="fold" open={part === "tangents" && isTwisted}>
          <summary>{words.lines[part]}</summary>
          {typeof Body === "string" ? (
            <p class="fold-wait">{waits[Body]}</p>
          ) : (
            <Body of={part} {...given} />
          )}
        </details>
      ))}
      <AskedFold store={given.store} name="atlas" summary={words.asked.atlas} load={loadAtlas} />
    </section>
  );
}
