// The Compose view: two quaternions, both products, both orders.
import type { ComposeReport } from "../../engine.ts";
import type { Store } from "../../state/store.ts";
import * as words from "../../words/compose/compose.tsx";
import { AskRest } from "../parts/Ask.tsx";
import { AskedFold } from "../parts/AskedFold.tsx";
import { CarryLinks } from "../parts/CarryLinks.tsx";
import { ConventionSwitch } from "../parts/ConventionSwitch.tsx";
import { presetItself } from "../parts/convention_names.ts";
import { Notes } from "../parts/Notes.tsx";
import { Picture } from "../parts/Picture.tsx";
import { TextField } from "../parts/TextField.tsx";
import { UndoRedo } from "../parts/UndoRedo.tsx";
import { spelled } from "./Formula.tsx";
import { Pair, ProductCard } from "./Products.tsx";
import { operands, ReadOperand } from "./ReadOperand.tsx";
import { Road } from "./Road.tsx";
import "../parts/fold.css";
import "../parts/result.css";
import "./compose.css";

const loadBetween = () => import("./Between.tsx").then(({ Between }) => Between);
const loadForms = () => import("./Chain.tsx").then(({ DeclaredForms }) => DeclaredForms);
const loadSwapped = () => import("./Chain.tsx").then(({ SwappedForms }) => SwappedForms);
const loadChain = () => import("./Chain.tsx").then(({ Chain }) => Chain);

export { spokenProduct } from "./spoken.ts";

export function Compose({ store }: { store: Store }) {
  const shownResult = store.compose.value;
  return (
    <>
      <section class="ask" aria-label={words.input}>
        <div class="ask-row">
          <div class="ask-pair">
            <TextField store={store} field="p" />
            <TextField store={store} field="q">
              <UndoRedo store={store} />
            </TextField>
          </div>
          <ConventionSwitch store={store} />
        </div>
        <AskRest store={store} freshness={shownResult?.freshness}>
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

/** How each text was read and what there is to know of it, in a line of its own. */
function ReadAs({ report, store }: { report: ComposeReport; store: Store }) {
  const { digits, unit } = store.state.value;
  return (
    <div class="read-as">
      {operands.map((operand) => (
        <div key={operand}>
          <ReadOperand operand={operand} report={report} digits={digits} unit={unit} />
          <Notes notes={report.notes.filter(({ field }) => field === operand)} store={store} />
        </div>
      ))}
      <Notes notes={report.notes.filter(({ field }) => field === "vector")} store={store} />
    </div>
  );
}

function Result({ report, store }: { report: ComposeReport; store: Store }) {
  const { digits, unit } = store.state.value;
  const { declared } = report;
  const isPreset = presetItself(declared.convention, store.engine) !== undefined;
  // Each product of the Hamilton kind stands beside the JPL product that has the same numbers.
  const pairs = report.products
    .filter((product) => product.convention.handedness === "right")
    .flatMap((hamilton) => {
      const jpl = report.products.find(
        ({ convention, left }) => convention.handedness === "left" && left === hamilton.right,
      );
      return jpl ? [{ hamilton, jpl }] : [];
    });
  // First the pair that is the same attitude as the product as declared.
  if (declared.direction === "world-to-body") pairs.reverse();
  const [headline, ...others] = pairs.map(({ hamilton, jpl }) => ({
    key: hamilton.left,
    // First the product as declared.
    tied: declared.convention.handedness === "left" ? [jpl, hamilton] : [hamilton, jpl],
  }));
  const shownAs = { engine: store.engine, declared, digits, unit };
  const carryLinks = (
    <CarryLinks
      store={store}
      of={spelled(declared)}
      quaternion={{ components: declared.quaternion, convention: declared.convention }}
      to={["read", "translate"]}
    />
  );
  return (
    <div class={`composed composed-${digits}`}>
      <div class="products">
        {!isPreset && (
          <ProductCard product={declared} heading="h2" {...shownAs}>
            {carryLinks}
          </ProductCard>
        )}
        {headline && (
          <Pair tied={headline.tied} tie={isPreset ? words.tie : words.tieOfPresets} {...shownAs}>
            {isPreset && carryLinks}
          </Pair>
        )}
        <AskedFold
          store={store}
          name="forms"
          summary={words.forms(headline?.tied.map(spelled).join(" = ") ?? spelled(declared))}
          load={loadForms}
        />
      </div>
      <Road report={report} engine={store.engine} digits={digits} unit={unit} />
      <Picture store={store} of="compose" />
      {others.map(({ key, tied }) => (
        <details key={key} class="fold">
          <summary>{words.otherOrder(tied.map(spelled).join(" = "))}</summary>
          <Pair tied={tied} tie={words.tie} {...shownAs} />
          <AskedFold
            store={store}
            name="other-forms"
            summary={words.forms(tied.map(spelled).join(" = "))}
            load={loadSwapped}
          />
        </details>
      ))}
      <AskedFold store={store} name="between" summary={words.between} load={loadBetween} />
      <AskedFold store={store} name="chain" summary={words.chain} load={loadChain} />
    </div>
  );
}
