// What follows from the choices, how it relates to Hamilton and JPL, and what numbers cannot tell.
import type { ComponentChildren } from "preact";
import type { CosineMatrix, Direction, Handedness, IdentifyReport, Side } from "../engine.ts";
import {
  familySays,
  listed,
  settledFamily,
  settledValue,
  sideWords,
  wordsOfValue,
} from "./identify_words.ts";
import { familyWords, takesWords } from "./library_words.ts";
import { axisWords, operatorOf } from "./words.ts";

export function Meaning({ report, name }: { report: IdentifyReport; name: string }) {
  return (
    <div class="facts meaning">
      <Relatives report={report} name={name} />
      <section class="fact" aria-labelledby="unsettled-name">
        <h2 id="unsettled-name">What no numbers tell</h2>
        <LabelWords report={report} />
      </section>
    </div>
  );
}

/** The library between Hamilton and JPL, side by side. */
function Relatives({ report, name }: { report: IdentifyReport; name: string }) {
  const { handedness, rotate, firstToAct } = report.remaining;
  const family = settledFamily(report.remaining);
  const products = (value: Handedness) => <Value choice="handedness" value={value} />;
  const rotations = (value: CosineMatrix) => <Value choice="rotate" value={value} />;
  const rows: { name: string; cells: ComponentChildren[] }[] = [
    {
      name: "product",
      cells: [products("right"), handedness.map(products), products("left")],
    },
    { name: "rotates a column by", cells: [rotations("R"), rotate.map(rotations), rotations("C")] },
    {
      name: "acts first in a * b",
      cells: [operand("right"), firstToAct.map(operand), operand("right")],
    },
  ];
  return (
    <section class="fact relatives" aria-labelledby="relatives-name">
      <h2 id="relatives-name">Between Hamilton and JPL</h2>
      <div class="table-scroll">
        <table>
          <thead>
            <tr>
              <td />
              <th scope="col" class="hamilton">
                Hamilton
              </th>
              <th scope="col" class="relatives-own">
                <span class="long-name">{name}</span>
              </th>
              <th scope="col" class="jpl">
                JPL
              </th>
            </tr>
          </thead>
          <tbody>
            {rows.map(({ name: row, cells: [hamilton, own, jpl] }) => (
              <tr key={row}>
                <th scope="row">{row}</th>
                <td>{hamilton}</td>
                <td class="relatives-own">{alternatives(own)}</td>
                <td>{jpl}</td>
              </tr>
            ))}
          </tbody>
        </table>
      </div>
      <p class="relatives-says">
        {family ? (
          <>
            <strong>{capital(familyWords[family][0])}.</strong> {familySays[family]}
          </>
        ) : (
          "Open until the product and the rotation are settled."
        )}
      </p>
      <Follows report={report} />
    </section>
  );
}

const operand = (side: Side) => <span>{side === "left" ? "a, the left" : "b, the right"}</span>;

const capital = (text: string) => text.charAt(0).toUpperCase() + text.slice(1);

/** One value, or both with `or` between them. */
function alternatives(cells: ComponentChildren): ComponentChildren {
  if (!Array.isArray(cells)) return cells;
  if (cells.length === 0) return "–";
  return cells.length === 1 ? cells[0] : <span class="open-cell">open</span>;
}

/** A value in the colour of its convention. */
function Value({ choice, value }: { choice: "handedness" | "rotate"; value: string }) {
  const words = wordsOfValue(choice, value);
  return (
    <span class={`convention-value ${words?.preset}`}>{words?.words.replace(/^.*, /, "")}</span>
  );
}

function Follows({ report: { remaining } }: { report: IdentifyReport }) {
  const { firstToAct, direction } = remaining;
  return (
    <ul class="notes follows">
      <li>
        {firstToAct.length === 1 && firstToAct[0] ? (
          <>
            In <code>a * b</code> <strong>{sideWords[firstToAct[0]]}</strong> acts first on a
            vector.
          </>
        ) : (
          "Which operand acts first follows from the product and the rotation: still open."
        )}
      </li>
      <li>
        {direction.length === 1 && direction[0] ? (
          <>
            For the attitude of a body the call that rotates takes{" "}
            <strong>{takesWords[direction[0]]}</strong>.
          </>
        ) : (
          "Which coordinates to which it takes depends on how an attitude is written: a body turned by a quarter tells."
        )}
      </li>
      {settledValue(remaining, "rotate") && settledValue(remaining, "matrix") && (
        <li>
          {settledValue(remaining, "rotate") === settledValue(remaining, "matrix") ? (
            <>
              Its matrix multiplies <strong>column vectors</strong> as the call that rotates does.
            </>
          ) : (
            <>
              Its matrix is the transpose of what rotates: it is for <strong>row vectors</strong>,
              x M, or it is the inverse.
            </>
          )}
        </li>
      )}
    </ul>
  );
}

/** MODEL-10: function and direction reversed together leave every number as it is. */
function LabelWords({ report: { labels, remaining } }: { report: IdentifyReport }) {
  if (remaining.direction.length === 0) return null;
  return (
    <>
      <p>
        A function and a direction reversed together leave every number as it is. Which of the two
        labels is meant, only the documentation says.
      </p>
      <dl class="labels">
        {remaining.direction.map((direction) => (
          <div key={direction}>
            <dt>{takesWords[direction]}</dt>
            <dd>
              {listed(
                labels.filter((label) => operatorOf(label) === direction).map(labelWords),
                "or",
              )}
            </dd>
          </div>
        ))}
      </dl>
    </>
  );
}

function labelWords({
  function: does,
  direction,
}: {
  function: "passive" | "active";
  direction: Direction;
}): string {
  const [name, effect] = axisWords.function.values[does];
  return `${name}, ${axisWords.direction.values[direction][0]} (${effect})`;
}
