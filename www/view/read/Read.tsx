// The Read view: one attitude, both conventions side by side.
import { toFragment } from "../../address/fragment.ts";
import type { ReadReport } from "../../engine.ts";
import { stateOf } from "../../model/examples/example.ts";
import { type FeaturedName, featured } from "../../model/examples/featured.ts";
import { shown, shownArray } from "../../number/format.ts";
import { showOverlay } from "../../state/overlay.ts";
import type { Store } from "../../state/store.ts";
import { lettersOf } from "../../words/conventions.ts";
import { examplesLabel, featuredNames, moreExamples } from "../../words/examples/featured.ts";
import * as words from "../../words/parts/ask.tsx";
import { AskRest } from "../parts/Ask.tsx";
import { ConventionSwitch } from "../parts/ConventionSwitch.tsx";
import { presetItself } from "../parts/convention_names.ts";
import { Notes } from "../parts/Notes.tsx";
import { Picture } from "../parts/Picture.tsx";
import { FormWords } from "../parts/ReadAs.tsx";
import { TextField } from "../parts/TextField.tsx";
import { UndoRedo } from "../parts/UndoRedo.tsx";
import { CaseLinks } from "./CaseLinks.tsx";
import { Columns } from "./Columns.tsx";
import { DeclaredCard } from "./Declared.tsx";
import { Facts } from "./Facts.tsx";
import { Folded } from "./Folded.tsx";
import { Relation } from "./Relation.tsx";
import "../parts/examples.css";
import "../parts/result.css";
import "./read.css";

export function Read({ store }: { store: Store }) {
  const shownResult = store.read.value;
  return (
    <>
      <section class="ask" aria-label={words.input}>
        <div class="ask-row">
          <TextField store={store} field="quaternion">
            <UndoRedo store={store} />
          </TextField>
          <ConventionSwitch store={store} />
        </div>
        <AskRest
          store={store}
          freshness={shownResult?.freshness}
          examples={<Examples store={store} />}
        >
          {shownResult && <ReadAs report={shownResult.report} store={store} />}
        </AskRest>
      </section>
      {shownResult && (
        <div class={`result ${shownResult.freshness}`}>
          <Result report={shownResult.report} store={store} />
        </div>
      )}
    </>
  );
}

/** Links, so that going back returns to what was typed before. */
function Examples({ store }: { store: Store }) {
  return (
    <div class="examples">
      <span id="examples-label" class="visually-hidden">
        {examplesLabel}
      </span>
      <ul aria-labelledby="examples-label">
        {Object.entries(featured).map(([name, example]) => (
          <li key={name}>
            <a href={`#${toFragment(stateOf(example, store.state.value))}`}>
              {featuredNames[name as FeaturedName]}
            </a>
          </li>
        ))}
      </ul>
      <button type="button" aria-haspopup="dialog" onClick={() => showOverlay("gallery")}>
        {moreExamples}
      </button>
    </div>
  );
}

/** What the text is and what there is to know of it; its four numbers stand in the columns. */
function ReadAs({ report, store }: { report: ReadReport; store: Store }) {
  const { digits, unit } = store.state.value;
  const { quaternion, vector } = report;
  const isQuaternion = quaternion.form.kind === "quaternion";
  return (
    <div class="read-as">
      <CaseLinks report={report} store={store} />
      <p class="read-as-text">
        {words.readAs}{" "}
        {isQuaternion ? (
          words.quaternionIn(<span class="letters">{lettersOf[quaternion.convention.order]}</span>)
        ) : (
          <FormWords quaternion={quaternion} digits={digits} unit={unit} />
        )}
        {isQuaternion && quaternion.norm !== undefined && (
          <span class="read-as-part">
            {words.norm} <code>{shown(quaternion.norm, digits)}</code>
          </span>
        )}
        <span class="read-as-part">
          <var>v</var> = <code>{shownArray(vector, digits)}</code>
        </span>
      </p>
      <Notes notes={report.notes} store={store} />
    </div>
  );
}

function Result({ report, store }: { report: ReadReport; store: Store }) {
  const { digits } = store.state.value;
  // What the numbers were declared as, which is not the switch's state while a text has a problem.
  const declared = presetItself(report.quaternion.convention, store.engine);
  return (
    <>
      {declared === undefined && <DeclaredCard report={report} store={store} digits={digits} />}
      <div class={`answer-grid answer-${digits}`}>
        <Columns report={report} store={store} declared={declared} digits={digits} />
        <Picture store={store} of="read" />
        <Relation report={report} digits={digits} declared={declared} />
        <Facts report={report} store={store} />
      </div>
      <Folded report={report} store={store} digits={digits} />
    </>
  );
}
