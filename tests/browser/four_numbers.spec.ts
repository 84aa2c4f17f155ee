// What is typed into one of four numbers, and where each of them stands, with the core and without a page.
import { readFileSync } from "node:fs";
import { expect, test } from "@playwright/test";
import { analyze, initSync, presets, readNumber } from "../../pkg/quatlas.js";
import type { Engine } from "../../www/engine.ts";
import { arrayOf, namesOf, otherOrder } from "../../www/model/component_order.ts";
import type { Store } from "../../www/state/store.ts";
import { componentOrderValues } from "../../www/values.ts";
import { numberOf } from "../../www/view/parts/number_group.ts";
import { lettersOf } from "../../www/words/conventions.ts";

initSync({ module: readFileSync(new URL("../../pkg/quatlas_bg.wasm", import.meta.url)) });

test("a part with or without its unit is the number that steps start from", () => {
  const engine: Pick<Engine, "readNumber"> = { readNumber };
  const store = { engine } as Store;
  const parts: [string, number | undefined][] = [
    ["0.5", 0.5],
    [" −2e3 ", -2000],
    ["1/2", 0.5],
    ["pi/4", Math.PI / 4],
    ["√2", Math.SQRT2],
    ["45°", 45],
    ["30deg", 30],
    ["1/2 rad", 0.5],
    ["90 / 2 DEG", 45],
    ["-0/3", 0],
    ["-0°", 0],
    ["", undefined],
    ["°", undefined],
    ["1 2", undefined],
    ["1,2", undefined],
    ["i", undefined],
    ["w=1", undefined],
    ["-", undefined],
    ["1e400", undefined],
    ["1/0", undefined],
    // In the text of the whole attitude the comment would take the rest of it.
    ["1 # one", undefined],
  ];
  for (const [part, number] of parts) {
    const found = numberOf(store, part);
    expect(Object.is(found, number), `${part}: ${found}`).toBe(true);
  }
});

test("four numbers stand where the core puts them", () => {
  for (const order of componentOrderValues) {
    const convention = { ...presets().hamilton, order };
    const outcome = analyze({
      view: "read",
      quaternion: "w=0.1 x=0.3 y=0.5 z=0.7",
      vector: "0 0 0",
      convention,
    });
    if (outcome.status !== "read") throw new Error("not read");
    const { components } = outcome.quaternion;
    expect(arrayOf(components, order)).toEqual(components.array);
    expect(arrayOf(components, otherOrder[order])).not.toEqual(components.array);
    expect(lettersOf[order]).toBe(namesOf[order].join(" "));
  }
});
