// A product of p and q as rotation vector and Euler angles, and its inverse in both notations.
import { columnValues, eulerValue } from "../../copy/values.ts";
import type { ChainReport, Operand, Request } from "../../engine.ts";
import { declaredConvention } from "../../model/conventions.ts";
import { sequenceName } from "../../model/euler_sequence.ts";
import type { PageState, Preset } from "../../model/page_state.ts";
import { fromRadians, shownAngle, shownAxis } from "../../number/format.ts";
import type { Store } from "../../state/store.ts";
import * as words from "../../words/compose/chain.tsx";
import { wordsOf } from "../../words/conventions.ts";
import { useAsked } from "../parts/asked.tsx";
import { ArrayRow } from "../parts/Value.tsx";

type Order = readonly [Operand, Operand];

/** By the left operand of the product as declared. */
const orders: Record<Operand, Order> = { p: ["p", "q"], q: ["q", "p"] };

const asks = (order: Order) => (state: PageState) => {
  const { matrix, euler } = state;
  const factors = order.map((operand) => ({ text: state[operand] }));
  const convention = declaredConvention(state);
  return { view: "chain", factors, convention, matrix, euler } satisfies Request;
};

/** The same function each time, by which the store knows the question. */
const askedOf = { p: asks(orders.p), q: asks(orders.q) };

export const DeclaredForms = ({ store }: { store: Store }) => <Forms store={store} left="p" />;
export const SwappedForms = ({ store }: { store: Store }) => <Forms store={store} left="q" />;

function Forms({ store, left }: { store: Store; left: Operand }) {
  const { report, old } = useAsked(store, askedOf[left], "chain");
  if (report === undefined) return null;
  const order = orders[left];
  const inNotation = (preset: Preset): Order => {
    // Factors stand in the declared order where the matrices lead the same way.
    const isListed = report[preset].rules.operator === report.declared.rules.operator;
    return isListed ? order : [order[1], order[0]];
  };
  return (
    <section class={`card asked ${old}`} aria-label={words.forms(inNotation("hamilton"))}>
      <div class="asked-columns">
        <div>
          <TurnRows store={store} report={report} />
        </div>
        <div>
          {(["hamilton", "jpl"] as const).map((preset) => {
            const column = report[preset];
            const name = words.inverseOf(inNotation(preset), preset);
            return (
              <ArrayRow
                key={preset}
                name={name}
                symbol={name}
                numbers={column.inverse?.array}
                digits={store.state.value.digits}
                note={`${wordsOf[preset].name} ${wordsOf[preset].order}`}
                value={columnValues(column, store.engine.describe).inverse}
              />
            );
          })}
        </div>
      </div>
    </section>
  );
}

/** What the product does to the body, as a vector and as angles. */
export function TurnRows({ store, report }: { store: Store; report: ChainReport }) {
  const { digits, unit } = store.state.value;
  const { turn, euler } = report;
  const angle = shownAngle(fromRadians(turn.angleRad), digits, unit);
  return (
    <>
      <ArrayRow
        name={words.rotationVector}
        symbol={words.rotationVector}
        numbers={turn.rotationVectorRad}
        digits={digits}
        note={turn.axis && words.turn(angle, shownAxis(turn.axis, digits))}
        value={{ kind: "rotation-vector", vectorRad: turn.rotationVectorRad }}
      />
      <ArrayRow
        name={words.euler(sequenceName(euler.sequence))}
        symbol={words.euler(sequenceName(euler.sequence))}
        numbers={unit === "degrees" ? euler.anglesDeg : euler.anglesRad}
        digits={digits}
        note={unit}
        value={eulerValue(euler)}
      />
    </>
  );
}
