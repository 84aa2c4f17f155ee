// Which convention a library of rotation matrices uses, from what it prints.
import type { MatricesReport, Request } from "../../engine.ts";
import type { PageState } from "../../model/page_state.ts";
import type { Store } from "../../state/store.ts";
import * as words from "../../words/identify/matrices.tsx";
import { problemOf } from "../../words/identify/observation.tsx";
import { useAsked } from "../parts/asked.tsx";
import { Text } from "./Numbers.tsx";
import "./matrices.css";

/** The texts, in the order of the address and of the fields. */
const names = ["yawed", "a", "b", "product", "rotationVector", "printed"] as const;
type Texts = Record<(typeof names)[number], string>;

const steps: readonly (readonly (keyof Texts)[])[] = [
  ["yawed"],
  ["a", "b", "product"],
  ["rotationVector", "printed"],
];

/** Turns by 90°, and by 0.1 rad, computed by hand. */
const examples: { name: keyof typeof words.exampleNames; texts: string }[] = [
  {
    name: "coordinates",
    texts: textOf({
      yawed: "[[0, 1, 0], [-1, 0, 0], [0, 0, 1]]",
      a: "[[0, 1, 0], [-1, 0, 0], [0, 0, 1]]",
      b: "[[1, 0, 0], [0, 0, 1], [0, -1, 0]]",
      product: "[[0, 1, 0], [0, 0, 1], [1, 0, 0]]",
      rotationVector: "0.1 0 0",
      printed: "[[0, 1, 0], [-0.995, 0, 0.0998], [0.0998, 0, 0.995]]",
    }),
  },
  {
    name: "vectors",
    texts: textOf({
      yawed: "[[0, -1, 0], [1, 0, 0], [0, 0, 1]]",
      a: "[[0, -1, 0], [1, 0, 0], [0, 0, 1]]",
      b: "[[1, 0, 0], [0, 0, -1], [0, 1, 0]]",
      product: "[[0, 0, 1], [1, 0, 0], [0, 1, 0]]",
      rotationVector: "0.1 0 0",
      printed: "[[0, -1, 0], [0.995, 0, 0.0998], [-0.0998, 0, 0.995]]",
    }),
  },
  { name: "empty", texts: "~" },
];

function textOf(texts: Texts): string {
  return names.map((name) => texts[name].replaceAll("~", " ")).join("~");
}

function textsOf({ matrices }: PageState): Texts {
  const written = (matrices || examples[0]?.texts || "").split("~");
  return Object.fromEntries(names.map((name, at) => [name, written[at] ?? ""])) as Texts;
}

/** The small turn is added to the first matrix: without that it is not known what its axes are. */
export function askedOfMatrices(state: PageState): Request {
  const texts = textsOf(state);
  return { view: "matrices", ...texts, matrix: texts.yawed };
}

export function Matrices({ store }: { store: Store }) {
  const { report, problems, old } = useAsked(store, askedOfMatrices, "matrices");
  const texts = textsOf(store.state.value);
  return (
    <section class="card asked" aria-label={words.title}>
      <p class="asked-lead">{words.lead}</p>
      <div class="examples">
        <span id="matrices-examples">{words.examples}</span>
        <ul aria-labelledby="matrices-examples">
          {examples.map(({ name, texts: example }) => (
            <li key={name}>
              <a
                href={store.linkTo({ matrices: example })}
                aria-current={
                  textOf(texts) === textOf(textsOf({ ...store.state.value, matrices: example }))
                    ? "true"
                    : undefined
                }
              >
                {words.exampleNames[name]}
              </a>
            </li>
          ))}
        </ul>
      </div>
      <ol class="matrices-steps">
        {steps.map((fields, step) => (
          <li key={step}>
            <p>{words.steps[step]}</p>
            <div class="matrices-texts">
              {fields.map((name) => {
                const problem = problems.find(({ field }) => field === name);
                const id = `matrices-${name}`;
                return (
                  <div key={name}>
                    <Text
                      label={words.fields[name]}
                      text={texts[name]}
                      problem={problem}
                      describedBy={id}
                      onInput={(typed) =>
                        store.set(
                          { matrices: textOf({ ...texts, [name]: typed }) },
                          { as: `matrices ${name}` },
                        )
                      }
                    />
                    <p class="problem" id={id} hidden={problem === undefined}>
                      {problem && problemOf(problem)}
                    </p>
                  </div>
                );
              })}
            </div>
          </li>
        ))}
      </ol>
      {report && (
        <div class={`asked ${old}`}>
          <Answer store={store} report={report} yawed={texts.yawed} />
        </div>
      )}
    </section>
  );
}

/** What the prints tell, each with what would tell it where it is open. */
function Answer({ store, report, yawed }: { store: Store; report: MatricesReport; yawed: string }) {
  const { operator, function: labels, direction, perturbation, incrementSign } = report;
  const told = [operator, labels, perturbation, incrementSign].filter((axis) => axis !== undefined);
  const rows = {
    operator: operator && words.operators[operator],
    labels: labels && words.functions[labels],
    direction: direction && words.directions[direction],
    axes: perturbation && words.axes[perturbation],
    sign: incrementSign && words.signs[incrementSign],
  };
  return (
    <>
      <p class="asked-sentence" role="status">
        {words.possible(2 ** (4 - told.length))}
      </p>
      <table class="readings">
        <caption class="visually-hidden">{words.answer}</caption>
        <tbody>
          {(Object.keys(rows) as (keyof typeof rows)[]).map((name) => (
            <tr key={name} class={rows[name] === undefined ? "" : "fits"}>
              <th scope="row">{words.rowNames[name]}</th>
              <td>{rows[name] ?? words.open[name]}</td>
            </tr>
          ))}
        </tbody>
      </table>
      {labels && direction && (
        <p>
          <a
            href={store.linkTo({
              view: "read",
              quaternion: yawed,
              matrix: { function: labels, direction },
            })}
          >
            {words.read}
          </a>
        </p>
      )}
    </>
  );
}
