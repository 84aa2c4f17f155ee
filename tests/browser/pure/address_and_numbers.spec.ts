// The pure functions of the page: the address and the number formats.
import { expect, test } from "@playwright/test";
import { fromFragment, isOfNewerVersion, toFragment } from "../../../www/address/fragment.ts";
import type { AxisMapping } from "../../../www/engine.ts";
import { axisPresets, inverseAxes } from "../../../www/model/axis_mapping.ts";
import { opening, type PageState } from "../../../www/model/page_state.ts";
import {
  alignedRows,
  exactArray,
  shown,
  shownArray,
  shownAxis,
} from "../../../www/number/format.ts";
import { axisPresetWords } from "../../../www/words/translate/axes_choice.tsx";

const jpl = {
  order: "scalar-last",
  handedness: "left",
  function: "passive",
  direction: "world-to-body",
  perturbation: "local",
} as const;

test("every state reads back from its fragment", () => {
  const states: PageState[] = [
    opening,
    { ...opening, view: "compose", p: "1 + i", q: "", digits: "all" },
    {
      ...opening,
      axes: { handedness: "left", perturbation: "global" },
      matrix: { function: "active", direction: "world-to-body" },
      euler: { axes: "zxz", frame: "extrinsic" },
    },
    {
      ...opening,
      view: "translate",
      translated: "1; 2, 3 ~ 4",
      from: { kind: "library", id: "eigen", order: "scalar-first", direction: "world-to-body" },
      to: { kind: "convention", convention: { ...jpl, perturbation: "global" } },
      worldAxes: "NED to ENU",
      bodyAxes: "x -y -z",
    },
    { ...opening, view: "translate", from: { kind: "convention", convention: jpl } },
    {
      ...opening,
      view: "identify",
      observations: [
        { probe: "components", quaternion: "1;2~3 4", printed: "~0 & =" },
        { probe: "matrix", quaternion: "i", printed: "[1;\n2]", layout: "unknown" },
        { probe: "from-matrix", matrix: "1 0 0", printed: "", layout: "rows" },
        { probe: "perturb", quaternion: "1", rotationVector: "0 0 0.1", printed: "🙂" },
        { probe: "quarter-turn", printed: "+" },
      ],
      libraryName: "X % +",
      language: "csharp",
      unavailable: ["rotate", "perturb"],
    },
    { ...opening, view: "identify", observations: [] },
    { ...opening, view: "libraries", find: "jpl & co", library: "openvins" },
    { ...opening, preset: "jpl", quaternion: "x: 1\ny: 2 & = # % +\n🙂", vector: "½" },
  ];
  for (const state of states) {
    expect(fromFragment(`#${toFragment(state)}`)).toEqual(state);
  }
  expect(toFragment(opening)).toBe("read");
});

test("a fragment of the new views can be read by people", () => {
  const translation: PageState = {
    ...opening,
    view: "translate",
    from: { kind: "library", id: "eigen", order: "scalar-first" },
    to: { kind: "convention", convention: { ...jpl, function: "active" } },
  };
  expect(toFragment(translation)).toBe(
    "translate?v=1&from=eigen~scalar-first&to=:scalar-last,left,active,world-to-body,local",
  );
  expect(toFragment({ ...opening, view: "identify", observations: [] })).toBe(
    "identify?v=1&probe=",
  );
});

test("an address says first which version of its meaning it is of", () => {
  expect(toFragment({ ...opening, digits: "4", p: "1" })).toBe("read?v=1&p=1&digits=4");
  expect(toFragment({ ...opening, view: "compose" })).toBe("compose");
  for (const fragment of ["#read?v=1&q=1", "#read?q=1", "#read", "", "#read?v=", "#read?v=-2"]) {
    expect(isOfNewerVersion(fragment), fragment).toBe(false);
  }
  for (const fragment of ["#read?v=2&q=1", "#read?q=1&v=12"]) {
    expect(isOfNewerVersion(fragment), fragment).toBe(true);
    expect(fromFragment(fragment)).toEqual({ ...opening, q: "1" });
  }
});

test("an address with ten thousand observations is cut, and a library that is none is not opened", () => {
  const probes = Array.from({ length: 10_000 }, () => "probe=quarter-turn;1 0 0 0").join("&");
  expect(fromFragment(`#identify?${probes}`).observations).toHaveLength(16);
  const state = fromFragment("#translate?from=nowhere&to=:1,2&library=nowhere", () => false);
  expect(state).toEqual({ ...opening, view: "translate" });
});

test("the text of a change of axes is turned back", () => {
  // New x is old z, new y is the opposite of old x, new z is old y.
  const mapping: AxisMapping = {
    axes: [
      { axis: "z", sense: "along" },
      { axis: "x", sense: "against" },
      { axis: "y", sense: "along" },
    ],
  };
  expect(inverseAxes("z -x y", mapping)).toBe("-y z x");
  expect(inverseAxes("ROS to OpenCV", mapping)).toBe("OpenCV to ROS");
  expect(inverseAxes("NED -> ENU", mapping)).toBe("ENU to NED");
  expect(inverseAxes("", undefined)).toBe("");
  expect(inverseAxes("oops", undefined)).toBe("oops");
  expect(Object.keys(axisPresetWords)).toEqual([...axisPresets]);
});

test("a fragment that says nonsense gives the opening state", () => {
  for (const fragment of [
    "",
    "#",
    "#nonsense?as=neither&digits=9",
    "#read?order=middle&handedness=both&matrix=x&rows=y&euler=zYx",
    "#read?%E0%A4%A",
    "#read?from=:jpl,left&to=:&probe=nothing;1&probe=%E0%A4%A&language=latin&unavailable=all,__proto__",
  ]) {
    expect(fromFragment(fragment)).toEqual(opening);
  }
});

test("numbers are rounded for reading and never lose their size", () => {
  expect(shown(0.70710678118, "4")).toBe("0.7071");
  expect(shown(-0.70710678118, "6")).toBe("−0.707107");
  expect(shown(-Math.SQRT1_2, "all")).toBe("−0.7071067811865476");
  expect(shown(1, "6")).toBe("1");
  expect(shown(1.5e-9, "6")).toBe("1.5e−9");
  expect(shown(2.5e300, "4")).toBe("2.5e300");
  expect(shown(1e21, "all")).toBe("1e21");
  expect(shown(-0.00001234567, "4")).toBe("−1.2346e−5");
});

test("what is rounding beside a larger number is shown as zero, except in all digits", () => {
  expect(shownArray([1, -7.85e-17, 0], "6")).toBe("[1, 0.000000, 0]");
  expect(shownArray([1, -7.85e-17, 0], "all")).toBe("[1, −7.85e−17, 0]");
  expect(shownArray([1e-9, -2e-9], "6")).toBe("[1e−9, −2e−9]");
});

test("decimal points of a column stand below each other", () => {
  expect(
    alignedRows(
      [
        [0.5, -1],
        [-0.25, 0],
      ],
      "4",
    ),
  ).toEqual([
    [" 0.5000", "−1"],
    ["−0.2500", " 0"],
  ]);
});

test("a copy reads back as the same double", () => {
  const numbers = [0.1, 1 / 3, 5e-324, 1.7976931348623157e308, -Math.SQRT1_2];
  expect(JSON.parse(exactArray(numbers))).toEqual(numbers);
});

test("an axis that is one of the frame has its name", () => {
  expect(shownAxis([0, 0, 1], "6")).toBe("z");
  expect(shownAxis([0, -1, 0], "6")).toBe("−y");
  expect(shownAxis([0.6, 0, 0.8], "4")).toBe("[0.6000, 0, 0.8000]");
});
