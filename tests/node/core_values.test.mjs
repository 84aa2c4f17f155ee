// What the page takes from the core and no longer says itself: lists of names, named conventions, and
// what conventions, libraries and numbers are. The formulas by which the page derived them stand here, as
// what is expected.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import * as whole from "../../pkg/quatlas.js";
import * as small from "../../pkg/small/quatlas_small.js";
import * as values from "../../pkg/values.js";

const inRoot = (path) => new URL(`../../${path}`, import.meta.url);
const bytes = (path) => readFileSync(inRoot(`pkg/${path}`));
whole.initSync({ module: bytes("quatlas_bg.wasm") });
small.initSync({ module: bytes("small/quatlas_small_bg.wasm") });
const cores = { whole, small };

const { hamilton } = whole.presets();
const axes = {
  order: values.componentOrderValues,
  handedness: values.handednessValues,
  function: values.functionValues,
  direction: values.directionValues,
  perturbation: values.perturbationValues,
};

/** The names that a core accepts, by what it says of one that it does not. */
function acceptedBy(ask) {
  const answer = () => {
    const outcome = ask("no such name");
    if (outcome.status === "refused") throw outcome.error;
  };
  let said = "";
  assert.throws(answer, (error) => {
    said = error.message;
    return error instanceof TypeError;
  });
  return [...said.split("one of")[1].matchAll(/`([^`]+)`/g)].map(([, name]) => name);
}

function checkList(list, ask) {
  assert.deepEqual(acceptedBy(ask), list);
  for (const name of list) assert.notEqual(ask(name).status, "refused", name);
}

test("the lists of the page hold exactly the names that both cores accept", () => {
  for (const core of Object.values(cores)) {
    for (const [axis, list] of Object.entries(axes)) {
      checkList([...list], (name) => core.describeConvention({ ...hamilton, [axis]: name }));
    }
    const read = (euler) =>
      core.analyze({
        view: "read",
        quaternion: "1 0 0 0",
        vector: "0 0 0",
        convention: hamilton,
        euler,
      });
    checkList([...values.eulerFrameValues], (frame) => read({ axes: "zyx", frame }));
    const sequence = (axes) => read({ axes, frame: "intrinsic" });
    const accepted = acceptedBy(sequence).map((name) => name.toLowerCase());
    assert.deepEqual(accepted, values.eulerAxesValues);
    for (const name of values.eulerAxesValues) assert.equal(sequence(name).status, "read", name);
  }
});

const identify = (more) => whole.analyze({ view: "identify", observations: [], ...more });

test("the lists of Identify hold exactly the names that the whole core accepts and answers", () => {
  checkList([...values.languageValues], (language) => identify({ language }));
  checkList([...values.probeKindValues], (kind) => identify({ unavailable: [kind] }));
  checkList([...values.matrixLayoutValues], (layout) =>
    identify({ observations: [{ probe: "matrix", quaternion: "", printed: "", layout }] }),
  );
  const { remaining, settled } = identify({});
  assert.deepEqual(settled, []);
  const { firstToAct, direction, ...choices } = remaining;
  assert.deepEqual(Object.keys(choices), values.behaviourAxisValues);
  assert.deepEqual(choices, {
    constructor: values.componentOrderValues,
    array: values.componentOrderValues,
    handedness: values.handednessValues,
    rotate: values.cosineMatrixValues,
    matrix: values.cosineMatrixValues,
    attitude: values.componentSignValues,
    perturbation: values.perturbationValues,
    incrementSign: values.incrementSignValues,
  });
});

test("the named conventions of the page are those of both cores", () => {
  for (const core of Object.values(cores))
    assert.deepEqual(values.namedConventions, core.presets());
  assert.deepEqual(Object.keys(values.namedConventions), values.namedConventionValues);
});

const other = (both, value) => both.find((one) => one !== value);
const agree = (names, one, convention) => names.every((name) => one[name] === convention[name]);

/** As the page derived it. */
const derived = {
  operator: ({ function: does, direction }) =>
    does === "passive" ? direction : other(values.directionValues, direction),
  reversed: (convention) => ({
    ...convention,
    direction: other(values.directionValues, convention.direction),
  }),
  hamiltonMatrix: (convention) => {
    const acts = derived.operator(convention);
    return convention.handedness === "right" ? acts : other(values.directionValues, acts);
  },
  preset: (convention) =>
    ["hamilton", "jpl"].find((name) =>
      agree(["handedness", "function", "direction"], values.namedConventions[name], convention),
    ),
  named: (convention) =>
    ["hamilton", "jpl", "hamiltonScalarLast", "jplBodyToWorld", "myLab"].find((name) =>
      agree(
        ["order", "handedness", "function", "direction"],
        values.namedConventions[name],
        convention,
      ),
    ),
};

test("of all 32 conventions both cores say what the page derived before", () => {
  let conventions = [{}];
  for (const [axis, both] of Object.entries(axes)) {
    conventions = conventions.flatMap((one) => both.map((value) => ({ ...one, [axis]: value })));
  }
  assert.equal(conventions.length, 32);
  for (const convention of conventions) {
    const report = whole.analyze({
      view: "read",
      quaternion: "w=1, x=0, y=0, z=0",
      vector: "0 0 0",
      convention,
    });
    for (const core of Object.values(cores)) {
      const { rules, ...described } = core.describeConvention(convention);
      assert.deepEqual(described, {
        named: derived.named(convention),
        preset: derived.preset(convention),
        hamiltonMatrix: derived.hamiltonMatrix(convention),
        reversed: derived.reversed(convention),
      });
      assert.equal(rules.operator, derived.operator(convention));
      assert.deepEqual(rules, report.rules);
      assert.equal(
        values.operatorDirections[convention.function][convention.direction],
        derived.operator(convention),
      );
    }
  }
});

const libraries = JSON.parse(readFileSync(inRoot("src/library/libraries.json"), "utf8"));

test("of the table the whole core holds what it translates with, and the small one nothing", () => {
  const texts = {
    whole: bytes("quatlas_bg.wasm").toString(),
    small: bytes("small/quatlas_small_bg.wasm").toString(),
  };
  for (const { id, code, numbers, note, calls, source, euler = [] } of libraries) {
    // Of a record without a quaternion, what its numbers mean.
    const held = code?.construct ?? numbers.means ?? id;
    assert.ok(texts.whole.includes(held), id);
    assert.ok(!texts.small.includes(held), id);
    const shown = [note, calls, source?.text, ...euler.map(({ call }) => call)];
    for (const text of shown.filter((text) => text?.length > 30)) {
      for (const core of Object.values(texts)) assert.ok(!core.includes(text), text);
    }
  }
});

test("what a library does is what it does as an end of a translation", () => {
  assert.ok(libraries.length > 60, `${libraries.length} libraries`);
  for (const { id } of libraries) {
    const end = { kind: "library", id };
    const { from } = whole.analyze({
      view: "translate",
      quaternion: "1 2 3 4",
      from: end,
      to: end,
    });
    const { convention, order, action, direction, family, firstToAct, assumed } = from;
    assert.deepEqual(
      whole.describeLibrary(id),
      { convention, order, action, direction, family, firstToAct, assumed },
      id,
    );
  }
  assert.equal(whole.describeLibrary("no such library"), undefined);
});

/** As the page read one number: the first of a vector. */
function firstOfVector(text) {
  const answer = whole.analyze({
    view: "read",
    quaternion: "w=1, x=0, y=0, z=0",
    vector: `[(${text}), 0, 0]`,
    convention: hamilton,
  });
  return answer.status === "read" ? answer.vector[0] : undefined;
}

test("one number in brackets reads as it did as the first of a vector", () => {
  const table = {
    ...{ "1/2": 0.5, "pi/4": Math.PI / 4, "√2": Math.SQRT2, "-√½": -Math.SQRT1_2, π: Math.PI },
    ...{ "30 + 15": 45, "-1/4": -0.25, "2*3": 6, "cos(45°)": Math.SQRT1_2, "1e-400": undefined },
    ...{ "": undefined, " ": undefined, "1 2": undefined, "1,2": undefined, "1,5": undefined },
    ...{ i: undefined, "2 i": undefined, "w=1": undefined, "-": undefined, "1e400": undefined },
    ...{ "45°": undefined, "30deg": undefined, "1 rad": undefined, "0x10": undefined },
    ...{ "1), (2": undefined, "1 # one": undefined, "[1]": 1, "--1": undefined, "1/0": undefined },
    ...{ "-0": 0, "0*-1": 0, "１": undefined, "1 000": undefined, nan: undefined },
  };
  for (const [text, expected] of Object.entries(table)) {
    assert.equal(firstOfVector(text), expected, text);
    for (const core of Object.values(cores)) {
      const number = core.readNumber(`(${text})`);
      // The page adds 0, so that no number is −0.
      assert.equal(number === undefined ? undefined : number + 0, expected, text);
    }
  }
});

test("the probes that are proposed are one of each kind, as an identification without any asks them", () => {
  const probes = whole.standardProbes();
  assert.deepEqual(probes.map(({ probe }) => probe).sort(), [...values.probeKindValues].sort());
  for (const language of values.languageValues) {
    for (const probe of probes) {
      const unavailable = values.probeKindValues.filter((kind) => kind !== probe.probe);
      assert.deepEqual(identify({ language, unavailable }).next?.probe, probe, language);
    }
  }
});

test("the family of an identification is what its product and its rotation make together", () => {
  const families = [];
  for (const product of ["0 0 0 1", "0 0 0 -1", ""]) {
    for (const rotated of ["3 1 2", "2 3 1", ""]) {
      const { family, remaining } = identify({
        observations: [
          { probe: "product", a: "0 1 0 0", b: "0 0 1 0", printed: product },
          { probe: "rotate", quaternion: "0.5 0.5 0.5 0.5", vector: "1 2 3", printed: rotated },
        ],
      });
      const { handedness, rotate } = remaining;
      const isSettled = handedness.length === 1 && rotate.length === 1;
      const ofRight = rotate[0] === "R" ? "hamilton" : "transposed-matrix";
      const ofLeft = rotate[0] === "C" ? "shuster" : "reversed-product";
      const expected = handedness[0] === "right" ? ofRight : ofLeft;
      assert.equal(family, isSettled ? expected : undefined, `${product}, ${rotated}`);
      if (family !== undefined) families.push(family);
    }
  }
  assert.deepEqual(families.sort(), [...values.familyValues].sort());
});
