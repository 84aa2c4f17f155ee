// The libraries of src/library/observations.json that npm installs in seconds, run again: what they print
// today is what was recorded.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { libraries } from "./adapters.mjs";
import { differences, entriesOf, runAgain } from "./rerun.mjs";

const read = (path) => JSON.parse(readFileSync(new URL(`../../${path}`, import.meta.url), "utf8"));
const { inputs, observations } = read("src/library/observations.json");
const records = read("src/library/libraries.json");
const locked = read("package-lock.json").packages;

for (const library of libraries) {
  const record = records.find(({ id }) => id === library.id);
  test(`${record.name} ${record.version} prints what was recorded`, (context) => {
    assert.equal(locked[`node_modules/${library.package}`].version, record.version);
    const entries = entriesOf(observations.find(({ id }) => id === library.id));
    const reasons = Object.entries(library.notRerun ?? {});
    for (const [name, reason] of reasons) {
      assert.ok(entries.some((entry) => entry.name === name) && reason, `${name} is recorded`);
    }
    const runs = entries
      .filter(({ name }) => !(name in (library.notRerun ?? {})))
      .map((entry) => ({ ...entry, run: runAgain(library, entry, inputs) }));
    const found = runs.flatMap(({ name, run, recorded }) =>
      differences(name, run, recorded, library.tolerance),
    );
    assert.deepEqual(found, []);

    const places = runs.flatMap((entry) => leaves(entry.recorded).map((path) => ({ entry, path })));
    assert.ok(places.length > 150, `${places.length} numbers`);
    for (const { entry, path } of places) {
      const changed = withChange(entry.recorded, path);
      const seen = differences(entry.name, entry.run, changed, library.tolerance);
      assert.equal(seen.length, 1, `${entry.name} at ${path}: another number would not be seen`);
    }
    context.diagnostic(`${places.length} numbers, ${reasons.length} entries not run again`);
  });
}

test("an error is right where an error is recorded, and only there", () => {
  const error = new Error("no rotation");
  assert.deepEqual(differences("matrix0", { error }, "ValueError: zero norm", 0), []);
  assert.equal(differences("matrix0", { value: [[0]] }, "ValueError: zero norm", 0).length, 1);
  assert.equal(differences("matrix0", { error }, [[0]], 0).length, 1);
  assert.equal(differences("matrix0", { value: Number.NaN }, 0, 1).length, 1);
});

/** The places of all numbers and texts in a recorded value. */
function leaves(recorded, path = []) {
  if (!Array.isArray(recorded)) return [path];
  return recorded.flatMap((member, at) => leaves(member, [...path, at]));
}

/** A recorded value with another number at one place, by some hundred tolerances or more. */
function withChange(recorded, [at, ...rest]) {
  if (Array.isArray(recorded)) return recorded.with(at, withChange(recorded[at], rest));
  return typeof recorded === "string" ? 0 : recorded + 1e-4;
}
