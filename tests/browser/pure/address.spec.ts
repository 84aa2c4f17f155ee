// The address, and the texts of changes of axes: pure functions, without a page.
import { expect, test } from "@playwright/test";
import { fromFragment, isOfNewerVersion, toFragment } from "../../../www/address/fragment.ts";
import type { AxisMapping } from "../../../www/engine.ts";
import { axisPresets, inverseAxes } from "../../../www/model/axis_mapping.ts";
import { opening, type PageState } from "../../../www/model/page_state.ts";
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
