// One attitude in all 16 conventions, those with equal numbers together.

import { columnValues } from "../../copy/values.ts";
import type { AtlasReport, Column, Convention, Request } from "../../engine.ts";
import { declaredConvention, differing, presetOf } from "../../model/conventions.ts";
import type { PageState } from "../../model/page_state.ts";
import { exactArray, shownArray } from "../../number/format.ts";
import type { Store } from "../../state/store.ts";
import { namedConventions } from "../../values.ts";
import { arrowOf, conventionNames, lettersOf, wordsOf } from "../../words/conventions.ts";
import * as words from "../../words/read/atlas.tsx";
import { useAsked } from "../parts/asked.tsx";
import { Copy } from "../parts/Copy.tsx";
import { SideScroll } from "../parts/SideScroll.tsx";
import "./atlas.css";

export function askedOfAtlas(state: PageState): Request {
  const { quaternion, matrix } = state;
  return { view: "atlas", quaternion, convention: declaredConvention(state), matrix };
}

export function Atlas({ store }: { store: Store }) {
  const { report, old } = useAsked(store, askedOfAtlas, "atlas");
  if (report === undefined) return <p class="asked-lead">{words.unread}</p>;
  const { digits } = store.state.value;
  const firsts = report.sameAs.filter((first, at) => first === at);
  return (
    <section class={`card asked atlas ${old}`} aria-label={words.title}>
      <p class="asked-lead">{words.lead}</p>
      <SideScroll name={words.rows} digits={digits}>
        <table aria-label={words.rows}>
          <thead>
            <tr>
              {words.heads.map((head) => (
                <th key={head} scope="col">
                  {head}
                </th>
              ))}
            </tr>
          </thead>
          {firsts.map((first) => (
            <Group key={first} store={store} report={report} first={first} />
          ))}
        </table>
      </SideScroll>
    </section>
  );
}

/** The rows that have the numbers of this one. */
function Group({ store, report, first }: { store: Store; report: AtlasReport; first: number }) {
  const { rows, sameAs } = report;
  const head = rows[first];
  if (head === undefined) return null;
  const { array } = head.quaternion;
  const letters = lettersOf[head.convention.order];
  return (
    <tbody>
      <tr class="atlas-numbers">
        <th colSpan={words.heads.length} scope="rowgroup">
          <div>
            <span class="letters">{letters}</span>{" "}
            <code>{shownArray(array, store.state.value.digits)}</code>{" "}
            <Copy
              of={words.array(letters)}
              text={exactArray(array)}
              value={columnValues(head, store.engine.describe).quaternion}
            />
          </div>
        </th>
      </tr>
      {rows.map(
        (row, at) => sameAs[at] === first && <Row key={at} store={store} row={row} at={at} />,
      )}
    </tbody>
  );
}

const axesAsked = ["order", "handedness", "function", "direction"] as const;

function Row({ store, row, at }: { store: Store; row: Column; at: number }) {
  const { convention, rules, named } = row;
  const preset = presetOf[convention.handedness];
  const declared = declaredConvention(store.state.value);
  const isDeclared = axesAsked.every((axis) => convention[axis] === declared[axis]);
  const { matrix, product } = wordsOf[preset];
  const isRight = (side: typeof rules.increment) => side === "right";
  return (
    <tr class={isDeclared ? "atlas-declared" : undefined}>
      <th scope="row">
        <label>
          <input
            type="radio"
            name="atlas"
            value={at}
            checked={isDeclared}
            onChange={() =>
              store.set({ preset, axes: differing(convention, namedConventions[preset]) })
            }
          />{" "}
          {words.meaning(product, convention.function, arrowOf(convention.direction))}
        </label>
        {named && <span class="atlas-name">{conventionNames[named]}</span>}
      </th>
      <td>
        <var>{matrix}</var>(<var>q</var>): {arrowOf(rules.operator)}
      </td>
      <td>{words.chain(isRight(rules.chainFirst))}</td>
      <td>{isRight(rules.increment) ? "q∘δq" : "δq∘q"}</td>
      <td>
        {rules.isCanonical ? "½ " : "−½ "}
        {isRight(rules.bodyRate) ? "q∘ω" : "ω∘q"}
      </td>
      <td>
        <Spellings convention={convention} isBodyToWorld={rules.operator === "body-to-world"} />
      </td>
    </tr>
  );
}

/** The label of this quaternion in each document (specification, MODEL-16). */
function Spellings({
  convention: { handedness, direction },
  isBodyToWorld,
}: {
  convention: Convention;
  isBodyToWorld: boolean;
}) {
  const isRight = handedness === "right";
  const cheng = isBodyToWorld === isRight ? "WB" : "BW";
  const guide = direction === "body-to-world" ? "BW" : "WB";
  const lecture = isBodyToWorld ? "WB" : "BW";
  return (
    <>
      <Label below={cheng[0]} above={cheng[1]} of={words.cheng} />
      <Label before={lecture[0]} below={lecture[1]} of={words.yoosefian} />
      {isRight && (
        <span>
          <var>Q</var>
          <sub>{lecture}</sub> <small>{words.lecture}</small>
        </span>
      )}
      <Label below={guide[0]} above={guide[1]} of={words.guide} />
    </>
  );
}

type Letter = string | undefined;

function Label(given: { before?: Letter; below?: Letter; above?: Letter; of: string }) {
  return (
    <span>
      {given.before && <sup>{given.before}</sup>}
      <var>q</var>
      <sub>{given.below}</sub>
      {given.above && <sup>{given.above}</sup>} <small>{given.of}</small>
    </span>
  );
}
