// Observations that no library can have made together.
import type { Contradiction } from "../engine.ts";
import type { Store } from "../state.ts";
import { claims } from "./identify_answer.ts";
import { checks, choiceWords, listed, wordsOfValue } from "./identify_words.ts";

export function ContradictionWords({ store, found }: { store: Store; found: Contradiction }) {
  const numbers = found.observations.map((at) => String(at + 1));
  const about = found.about.map((choice) => choiceWords[choice].about);
  return (
    <div class="problem contradiction">
      <p class="problem-message">
        Observations {listed(numbers)} cannot {numbers.length === 2 ? "both" : "all"} be true
        {about.length > 0 ? `: they disagree about ${listed(about)}` : ""}.
      </p>
      <table class="claims">
        <caption class="visually-hidden">What each of them says</caption>
        <tbody>
          {claims(store, found).map(({ at, says, leavesWithout }) => (
            <tr key={at}>
              <th scope="row">{at + 1}</th>
              <td>
                {says.length > 0
                  ? listed(
                      says.map(({ choice, value }) => wordsOfValue(choice, value)?.words ?? value),
                    )
                  : "only with the others"}
              </td>
              <td class="claim-without">
                {leavesWithout === 0
                  ? "without it the others still disagree"
                  : `without it ${leavesWithout} of 128 left`}
              </td>
            </tr>
          ))}
        </tbody>
      </table>
      <p>
        <span class="problem-key">Check</span>{" "}
        {[...found.about.map((choice) => checks[choice]), "that all come from one library"].join(
          "; ",
        )}
        .
      </p>
    </div>
  );
}
