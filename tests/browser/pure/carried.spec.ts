// A case that is carried to another view is the same attitude there, by the core: every convention, with
// numbers whose order, signs and direction all show.
import { readFileSync } from "node:fs";
import { expect, test } from "@playwright/test";
import { analyze, describeLibrary, initSync } from "../../../pkg/quatlas.js";
import { fromFragment, toFragment } from "../../../www/address/fragment.ts";
import type { Convention, Library, Outcome, TranslateReport } from "../../../www/engine.ts";
import { settledConvention } from "../../../www/model/behaviour.ts";
import {
  type CarriedQuaternion,
  type CarryTarget,
  carriedTo,
  translatedFrom,
} from "../../../www/model/carried.ts";
import { axisValues, declaredConvention } from "../../../www/model/conventions.ts";
import { opening, type PageState } from "../../../www/model/page_state.ts";
import { namedConventions } from "../../../www/values.ts";
import { askedOf } from "../support/asked.ts";

const root = new URL("../../../", import.meta.url);
initSync({ module: readFileSync(new URL("pkg/quatlas_bg.wasm", root)) });

const numbers = "0.1 -0.2 0.4 0.888819441731559";

/** The eight conventions, each in both orders. */
const conventions: Convention[] = axisValues.order.flatMap((order) =>
  axisValues.handedness.flatMap((handedness) =>
    axisValues.function.flatMap((does) =>
      axisValues.direction.map((direction) => ({
        ...{ order, handedness, function: does, direction },
        perturbation: order === "scalar-first" ? "global" : ("local" as const),
      })),
    ),
  ),
);

type Of<Status> = Extract<Outcome, { status: Status }>;

function ask<Status extends "read" | "compose" | "translate">(state: PageState, status: Status) {
  const request = askedOf(state);
  const outcome = request && analyze(request);
  if (outcome?.status !== status) throw new Error(`${toFragment(state)}: ${outcome?.status}`);
  return outcome as Of<Status>;
}

/** The state that the link opens, by its address, from a page on which much else is chosen. */
function opened(target: CarryTarget, quaternion: CarriedQuaternion): PageState {
  const page: PageState = {
    ...opening,
    preset: "jpl",
    axes: { direction: "body-to-world", perturbation: "global" },
    p: "w=1 x=0 y=0 z=0",
    worldAxes: "NED to ENU",
    from: { kind: "library", id: "eigen" },
    to: { kind: "convention", convention: namedConventions.hamilton },
  };
  return fromFragment(toFragment({ ...page, ...carriedTo[target](quaternion) }));
}

/** The matrix of an attitude from body to world. */
function attitudeOf({ components, convention }: CarriedQuaternion): number[] {
  const { w, x, y, z } = components;
  const quaternion = `w=${w} x=${x} y=${y} z=${z}`;
  const outcome = analyze({ view: "read", quaternion, vector: "1 2 3", convention });
  if (outcome.status !== "read") throw new Error(quaternion);
  return outcome.hamilton.matrix.flat();
}

function expectSame(found: readonly number[], wanted: readonly number[], at: string) {
  const off = Math.max(...wanted.map((number, place) => Math.abs(number - (found[place] ?? NaN))));
  expect(off, at).toBeLessThan(1e-15);
}

/** What arrives in each view, as a matrix from body to world. */
const arrived: Record<CarryTarget, (state: PageState) => number[]> = {
  read: (state) => ask(state, "read").hamilton.matrix.flat(),
  // After the identity it is what it was.
  compose: (state) => {
    const { quaternion, convention } = ask(state, "compose").declared;
    return attitudeOf({ components: quaternion, convention });
  },
  translate: (state) => attitudeOf(ask(state, "translate").to),
};
const targets = Object.keys(carriedTo) as CarryTarget[];

function expectCarried(quaternion: CarriedQuaternion, name: string) {
  const wanted = attitudeOf(quaternion);
  for (const target of targets) {
    const state = opened(target, quaternion);
    expect(state.view).toBe(target);
    expectSame(arrived[target](state), wanted, `${name} to ${target}`);
  }
}

test("the numbers of Read are the same attitude in every view, in all conventions", () => {
  expect(conventions).toHaveLength(16);
  const attitudes = new Set<string>();
  for (const convention of conventions) {
    const outcome = analyze({ view: "read", quaternion: numbers, vector: "1 2 3", convention });
    if (outcome.status !== "read") throw new Error("not read");
    const name = Object.values(convention).join(" ");
    for (const of of [outcome.declared, outcome.hamilton, outcome.jpl]) {
      expectCarried({ components: of.quaternion, convention: of.convention }, name);
      expectSame(
        attitudeOf({ components: of.quaternion, convention: of.convention }),
        outcome.hamilton.matrix.flat(),
        name,
      );
    }
    attitudes.add(
      outcome.hamilton.matrix
        .flat()
        .map((number) => number.toFixed(9))
        .join(),
    );
    // All five choices arrive, and every digit.
    const quaternion = { components: outcome.declared.quaternion, convention };
    for (const target of ["read", "compose"] as const) {
      expect(declaredConvention(opened(target, quaternion))).toEqual(convention);
    }
    expect(opened("translate", quaternion).from).toEqual({ kind: "convention", convention });
    // In the order that is declared, as the numbers beside it stand.
    const first = convention.order === "scalar-first" ? /^w=0\.1 x=-0\.2 / : /^x=0\.1 y=-0\.2 /;
    expect(opened("read", quaternion).quaternion).toMatch(first);
    expect(ask(opened("read", quaternion), "read").declared.quaternion.array).toEqual([
      0.1, -0.2, 0.4, 0.888819441731559,
    ]);
  }
  // Were a choice lost, another attitude would arrive: two orders, each with its inverse.
  expect(attitudes.size).toBe(4);
});

test("a product is the same attitude in every view", () => {
  for (const convention of conventions) {
    const outcome = analyze({
      view: "compose",
      p: "0 0 0.6 0.8",
      q: numbers,
      vector: "1 2 3",
      convention,
    });
    if (outcome.status !== "compose") throw new Error("not composed");
    for (const product of [outcome.declared, ...outcome.products]) {
      const { quaternion: components, convention } = product;
      expectCarried({ components, convention }, Object.values(convention).join(" "));
    }
  }
});

const table = readFileSync(new URL("src/library/libraries.json", root), "utf8");
const libraries: Library[] = JSON.parse(table);

test("both ends of every translation are the same attitude in every view", () => {
  expect(libraries.length).toBeGreaterThan(50);
  for (const { id } of libraries) {
    const from = { kind: "library", id } as const;
    const to = { kind: "library", id: "openvins" } as const;
    const report = ask(
      { ...opening, view: "translate", translated: numbers, from, to },
      "translate",
    );
    expectSame(attitudeOf(report.to), attitudeOf(report.from), id);
    expectCarried(report.from, id);
    expectCarried(report.to, id);
  }
});

test("numbers of another norm, and the smallest, arrive as they are", () => {
  const convention = namedConventions.jpl;
  const components = { w: -3, x: 1e-300, y: 0.1 + 0.2, z: -5e-324 };
  const { components: read, norm } = ask(
    opened("read", { components, convention }),
    "read",
  ).quaternion;
  expect(read).toMatchObject(components);
  expect(norm).toBeGreaterThan(3);
});

/** What a library prints, as its record says, is asked of Identify. */
function identified(observations: PageState["observations"]) {
  const outcome = analyze({
    ...{ view: "identify", observations: [...observations] },
    ...{ name: "X", language: "python", unavailable: [] },
  } as Parameters<typeof analyze>[0]);
  if (outcome.status !== "identify") throw new Error("not identified");
  return outcome;
}

test("the convention that was identified translates as the libraries that agree", () => {
  const answer = identified(opening.observations);
  const convention = settledConvention(answer.remaining);
  expect(convention).toEqual({ ...namedConventions.hamilton, order: "scalar-last" });
  if (convention === undefined) throw new Error("not settled");
  const translate = (change: Partial<PageState>): TranslateReport =>
    ask({ ...opening, ...change }, "translate");
  const own = translate(translatedFrom({ kind: "convention", convention }));
  const agreeing = answer.libraries.filter(({ unestablished }) => unestablished.length === 0);
  expect(agreeing.length).toBeGreaterThan(0);
  for (const { id } of agreeing) {
    if (describeLibrary(id)?.direction !== convention.direction) continue;
    expect(translate(translatedFrom({ kind: "library", id })).to.array, id).toEqual(own.to.array);
  }
});

test("what is not settled is no convention to translate from", () => {
  expect(settledConvention(identified([]).remaining)).toBeUndefined();
  const [product, ...others] = opening.observations;
  expect(settledConvention(identified(product ? [product] : []).remaining)).toBeUndefined();
  expect(settledConvention(identified(others).remaining)).toBeUndefined();
});
