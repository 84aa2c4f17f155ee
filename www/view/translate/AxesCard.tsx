// The change of axes on the way, with its matrices.
import { newAxesValue } from "../../copy/end_values.ts";
import type { AxesReport, MappedAxes } from "../../engine.ts";
import type { Digits } from "../../model/page_state.ts";
import * as words from "../../words/translate/axes_card.tsx";
import { Matrix } from "../parts/Value.tsx";
import "../parts/result.css";
import "./axes_card.css";

/** The change of axes, with its matrices. */
export function AxesCard({ axes, digits }: { axes: AxesReport; digits: Digits }) {
  return (
    <section class="card column custom" aria-labelledby="axes-name">
      <header>
        <h2 id="axes-name">{words.title}</h2>
        <p class="effect">{words.formula}</p>
      </header>
      <div class="matrices">
        <Mapped of="world" mapped={axes.world} digits={digits} />
        <Mapped of="body" mapped={axes.body} digits={digits} />
      </div>
      <p class="hand-words">
        {axes.world.text !== axes.body.text
          ? words.different(axes.world.hand)
          : axes.world.hand === "changed"
            ? words.mirrored
            : words.kept}
      </p>
    </section>
  );
}

function Mapped({
  of,
  mapped,
  digits,
}: {
  of: "world" | "body";
  mapped: MappedAxes;
  digits: Digits;
}) {
  return (
    <Matrix
      name={words.matrix(of)}
      symbol={
        <>
          <var>A</var>
          <sub>{words.frameWords[of]}</sub>
        </>
      }
      caption={words.caption(mapped)}
      rows={mapped.rows}
      value={newAxesValue(of, mapped.rows, mapped.text)}
      digits={digits}
    />
  );
}
