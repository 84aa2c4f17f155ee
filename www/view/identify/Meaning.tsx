// What follows from the choices, how it relates to Hamilton and JPL, and what numbers cannot tell.
import type { ComponentChildren } from "preact";
import type { CosineMatrix, Direction, Handedness, IdentifyReport, Side } from "../../engine.ts";
import { presetOfValue, settledValue } from "../../model/behaviour.ts";
import { operatorOf } from "../../model/conventions.ts";
import { axisWords, wordsOf } from "../../words/conventions.ts";
import { familySays, sideWords } from "../../words/identify/choices.ts";
import * as words from "../../words/identify/meaning.tsx";
import { familyWords, productWords, takesWords } from "../../words/library_behaviour.ts";
import { capital, unbroken } from "../../words/phrases.ts";
import { wordsOfValue } from "./choices.ts";
import "../parts/result.css";
import "./meaning.css";

export function Meaning({ report, name }: { report: IdentifyReport; name: string }) {
  return (
    <div class="facts meaning">
      <Relatives report={report} name={name} />
      <section class="fact" aria-labelledby="unsettled-name">
        <h2 id="unsettled-name">{words.unsettled}</h2>
        <LabelWords report={report} />
      </section>
    </div>
  );
}

/** The library between Hamilton and JPL, side by side. */
function Relatives({ report, name }: { report: IdentifyReport; name: string }) {
  const { family } = report;
  const { handedness, rotate, firstToAct } = report.remaining;
  const products = (value: Handedness) => <Value value={value} />;
  const rotations = (value: CosineMatrix) => <Value value={value} />;
  const rows: { name: string; cells: ComponentChildren[] }[] = [
    {
      name: words.product,
      cells: [products("right"), handedness.map(products), products("left")],
    },
    {
      name: words.rotates,
      cells: [rotations("R"), rotate.map(rotations), rotations("C")],
    },
    {
      name: words.actsFirst,
      cells: [operand("right"), firstToAct.map(operand), operand("right")],
    },
  ];
  return (
    <section class="fact relatives" aria-labelledby="relatives-name">
      <h2 id="relatives-name">{words.relatives}</h2>
      <div class="table-scroll">
        <table>
          <thead>
            <tr>
              <td />
              <th scope="col" class="hamilton">
                {wordsOf.hamilton.name}
              </th>
              <th scope="col" class="relatives-own">
                <span class="long-name">{name}</span>
              </th>
              <th scope="col" class="jpl">
                {wordsOf.jpl.name}
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
          words.familyOpen
        )}
      </p>
      <Follows report={report} />
    </section>
  );
}

const operand = (side: Side) => <span>{words.operand[side]}</span>;

/** One value, or both with `or` between them. */
function alternatives(cells: ComponentChildren): ComponentChildren {
  if (!Array.isArray(cells)) return cells;
  if (cells.length === 0) return "–";
  return cells.length === 1 ? cells[0] : <span class="open-cell">{words.open}</span>;
}

/** A product by its rule alone: its convention is the heading of the column. */
const shownOf = (value: Handedness | CosineMatrix) =>
  value === "right" || value === "left"
    ? unbroken(productWords[value])
    : wordsOfValue("rotate", value);

/** A value in the colour of its convention. */
function Value({ value }: { value: Handedness | CosineMatrix }) {
  return <span class={`convention-value ${presetOfValue[value]}`}>{shownOf(value)}</span>;
}

function Follows({ report: { remaining } }: { report: IdentifyReport }) {
  const { firstToAct, direction } = remaining;
  const axes = settledValue(remaining, "perturbation");
  const turn = settledValue(remaining, "incrementSign");
  return (
    <ul class="notes follows">
      <li>
        {firstToAct.length === 1 && firstToAct[0]
          ? words.first(sideWords[firstToAct[0]])
          : words.firstOpen}
      </li>
      <li>
        {direction.length === 1 && direction[0]
          ? words.takes(takesWords[direction[0]])
          : words.takesOpen}
      </li>
      <li>
        {axes && turn
          ? words.smallTurn(wordsOfValue("perturbation", axes), wordsOfValue("incrementSign", turn))
          : words.smallTurnOpen}
      </li>
      {settledValue(remaining, "rotate") && settledValue(remaining, "matrix") && (
        <li>
          {settledValue(remaining, "rotate") === settledValue(remaining, "matrix")
            ? words.columns
            : words.rows}
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
      <p>{words.labels}</p>
      <dl class="labels">
        {remaining.direction.map((direction) => (
          <div key={direction}>
            <dt>{takesWords[direction]}</dt>
            <dd>
              {words.either(
                labels.filter((label) => operatorOf(label) === direction).map(labelWords),
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
  return words.label(name, axisWords.direction.values[direction][0], effect);
}
