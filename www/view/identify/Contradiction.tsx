// Observations that no library can have made together.
import type { Contradiction } from "../../engine.ts";
import type { Store } from "../../state/store.ts";
import * as words from "../../words/identify/contradiction.tsx";
import { listed } from "../../words/phrases.ts";
import { wordsOfValue } from "./choices.ts";
import { claims } from "./kept_answer.ts";
import "../parts/ask.css";
import "./contradiction.css";

export function ContradictionWords({ store, found }: { store: Store; found: Contradiction }) {
  return (
    <div class="problem contradiction">
      <p class="problem-message">{words.message(found)}</p>
      <table class="claims">
        <caption class="visually-hidden">{words.claims}</caption>
        <tbody>
          {claims(store, found).map(({ at, says, leavesWithout }) => (
            <tr key={at}>
              <th scope="row">{at + 1}</th>
              <td>
                {says.length > 0
                  ? listed(says.map(({ choice, value }) => wordsOfValue(choice, value)))
                  : words.nothing}
              </td>
              <td class="claim-without">{words.without(leavesWithout)}</td>
            </tr>
          ))}
        </tbody>
      </table>
      <p>{words.check(found.about)}</p>
    </div>
  );
}
