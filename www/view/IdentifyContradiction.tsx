// Observations that no library can have made together.
import type { Contradiction } from "../engine.ts";
import type { Store } from "../state.ts";
import { contradictionWords } from "../words/identify.tsx";
import { listed } from "../words/phrases.ts";
import { claims } from "./identify_answer.ts";
import { wordsOfValue } from "./identify_choices.ts";

export function ContradictionWords({ store, found }: { store: Store; found: Contradiction }) {
  return (
    <div class="problem contradiction">
      <p class="problem-message">{contradictionWords.message(found)}</p>
      <table class="claims">
        <caption class="visually-hidden">{contradictionWords.claims}</caption>
        <tbody>
          {claims(store, found).map(({ at, says, leavesWithout }) => (
            <tr key={at}>
              <th scope="row">{at + 1}</th>
              <td>
                {says.length > 0
                  ? listed(says.map(({ choice, value }) => wordsOfValue(choice, value)))
                  : contradictionWords.withOthers}
              </td>
              <td class="claim-without">{contradictionWords.without(leavesWithout)}</td>
            </tr>
          ))}
        </tbody>
      </table>
      <p>{contradictionWords.check(found.about)}</p>
    </div>
  );
}
