// A quaternion with the formula that makes it: on which side the factor stands, with which sign.
import type { Convention, Describe, SidedQuaternion } from "../../engine.ts";
import type { Copied } from "../../model/copied.ts";
import type { Store } from "../../state/store.ts";
import { declared } from "../../words/motion/motion.tsx";
import { ComponentStrip } from "../parts/Value.tsx";

/** The three conventions, without the declared one where it is one of the other two. */
export function distinct(rows: readonly SidedQuaternion[]): SidedQuaternion[] {
  const [own, ...presets] = rows;
  const key = ({ convention }: SidedQuaternion) =>
    JSON.stringify([
      convention.order,
      convention.handedness,
      convention.function,
      convention.direction,
    ]);
  if (own === undefined) return [];
  const isPreset = presets.some((preset) => key(preset) === key(own));
  if (!isPreset) return [own, ...presets];
  // First the one that is declared.
  return presets.sort((a, b) => Number(key(b) === key(own)) - Number(key(a) === key(own)));
}

export function nameIn({ handedness, function: does, direction, order }: Convention): string {
  if (does === "active") return declared;
  if (handedness === "right" && direction === "body-to-world" && order === "scalar-first") {
    return "Hamilton";
  }
  return handedness === "left" && direction === "world-to-body" && order === "scalar-last"
    ? "JPL"
    : declared;
}

const accents: Record<string, string> = { Hamilton: "hamilton", JPL: "jpl" };

/** `q ⊙ Exp(−δ)`, with the factor as it is written. */
export function formulaOf(
  { convention, side, sign }: SidedQuaternion,
  before: string,
  factor: (sign: string) => string,
) {
  const operator = convention.handedness === "right" ? "⊙" : "⊗";
  const written = factor(sign < 0 ? "−" : "");
  return before + (side === "right" ? `q ${operator} ${written}` : `${written} ${operator} q`);
}

export function SidedStrips({
  store,
  rows,
  symbol,
  name,
  formula,
  value,
}: {
  store: Store;
  rows: readonly SidedQuaternion[];
  symbol: string;
  name: (convention: string) => string;
  formula: (row: SidedQuaternion) => string;
  value: (row: SidedQuaternion, describe: Describe) => Copied;
}) {
  const { digits } = store.state.value;
  return (
    <>
      {distinct(rows).map((row) => {
        const convention = nameIn(row.convention);
        return (
          <div key={convention} class={`motion-sided ${accents[convention] ?? "custom"}`}>
            <p>
              <b>{convention}</b> <span>{formula(row)}</span>
            </p>
            <ComponentStrip
              symbol={symbol}
              name={name(convention)}
              components={row.quaternion}
              convention={row.convention}
              digits={digits}
              value={value(row, store.engine.describe)}
            />
          </div>
        );
      })}
    </>
  );
}
