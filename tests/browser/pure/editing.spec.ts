// The pure functions of editing: the texts that edited numbers give, the steps of the arrow keys, and
// the history.
import { expect, test } from "@playwright/test";
import { endOfChange } from "../../../www/action/undo_by_key.ts";
import { opening, type PageState } from "../../../www/model/page_state.ts";
import { type Description, editedState, editedText } from "../../../www/number/edited_text.ts";
import { stepped } from "../../../www/number/stepping.ts";
import { closed, noHistory, recorded, redone, undone } from "../../../www/state/history.ts";

const jplNames = {
  kind: "components",
  names: ["x", "y", "z", "w"],
  order: "scalar-first",
  isConjugate: true,
} as const;
const zyx = { axes: "zyx", frame: "intrinsic" } as const;
const about = (unit: "degrees" | "radians") => ({ kind: "axis-angle", unit }) as const;

const texts: [Description, string[], string][] = [
  [{ ...jplNames, isConjugate: false }, ["1", "-2", "3", "4"], "qw=4, qx=1, qy=-2, qz=3"],
  // A conjugate has the opposite vector part; zero has no sign.
  [jplNames, ["1", "-2", "0", "-4"], "qw=-4, qx=-1, qy=2, qz=0"],
  [jplNames, ["1/√2", "−.5e-3", "+2", "4"], "qw=4, qx=-(1/√2), qy=.5e-3, qz=-2"],
  [jplNames, ["", " ", "2", "4"], "qw=4, qx=?, qy=?, qz=-2"],
  [
    { kind: "matrix", direction: "world-to-body" },
    ["1", "0", "0", "0", "√½", "-1/√2", "0", "1/2", ""],
    "[1, 0, 0; 0, (√½), (-1/√2); 0, (1/2), ?]",
  ],
  [about("degrees"), ["30 + 15", "0", "-1/2", "1"], "(30 + 15)° about [0, (-1/2), 1]"],
  [about("degrees"), ["45 deg", "0", "0", "1"], "45° about [0, 0, 1]"],
  // A π means radians.
  [about("degrees"), ["pi/4", "0", "0", "1"], "(pi/4) rad about [0, 0, 1]"],
  [about("radians"), ["45°", "0", "0", "1"], "45° about [0, 0, 1]"],
  [about("radians"), ["0.5", "0", "0", "1"], "0.5 rad about [0, 0, 1]"],
  [{ kind: "rotation-vector" }, ["0", "0.5", "pi/4"], "rotvec [0, 0.5, (pi/4)] rad"],
  [{ kind: "rotation-vector" }, ["0°", "0.5", "45°"], "rotvec [0, 0.5, (45*pi/180)] rad"],
  [
    { kind: "euler-angles", sequence: zyx, unit: "degrees" },
    ["30", "-20", "1+9"],
    "ZYX 30°, -20°, (1+9)°",
  ],
  // The angles of one text have one unit.
  [
    { kind: "euler-angles", sequence: { axes: "zxz", frame: "extrinsic" }, unit: "degrees" },
    ["30", "π/2", "0"],
    "zxz (30*pi/180) rad, (π/2) rad, 0 rad",
  ],
];

test("what is typed into numbers becomes a text of all of them, with their places", () => {
  for (const [description, parts, expected] of texts) {
    const { text, places } = editedText(description, parts);
    expect(text).toBe(expected);
    expect(places).toHaveLength(parts.length);
    for (const [at, part] of parts.entries()) {
      const digits = /[\d.]+|$/.exec(part)?.[0] ?? "";
      expect(text.slice(places[at]?.start, places[at]?.end)).toContain(digits);
    }
  }
});

test("nine numbers mean the matrix that they were typed into", () => {
  expect(editedState({ kind: "matrix", direction: "world-to-body" }, "…")).toEqual({
    quaternion: "…",
    matrix: { function: "passive", direction: "world-to-body" },
  });
  expect(editedState({ kind: "rotation-vector" }, "…")).toEqual({ quaternion: "…" });
});

test("the arrow keys keep the decimals", () => {
  expect(stepped(0.3, 0.01, "usual", -1)).toBe("0.29");
  expect(stepped(0.1, 0.01, "usual", 1)).toBe("0.11");
  expect(stepped(45, 1, "usual", 1)).toBe("46");
  expect(stepped(45.25, 1, "long", -1)).toBe("35.25");
  expect(stepped(45, 1, "short", 1)).toBe("45.1");
  expect(stepped(-0.01, 0.01, "usual", 1)).toBe("0");
  expect(stepped(Math.SQRT1_2, 0.01, "usual", 1)).toMatch(/^0\.71710678118654\d+$/);
  expect(stepped(1e-7, 0.01, "usual", 1)).toBe("0.0100001");
  expect(stepped(1e300, 1, "usual", 1)).toBe("1e+300");
  expect(stepped(1.7976931348623157e308, 1, "usual", 1)).toBe("1.7976931348623157e+308");
});

test("the caret stands where what was undone ends", () => {
  expect(endOfChange("1 0 0 0", "1 0.5 0 0")).toBe(5);
  expect(endOfChange("1 0.5 0 0", "1 0 0 0")).toBe(3);
  expect(endOfChange("", "abc")).toBe(3);
  expect(endOfChange("aa", "a")).toBe(0);
});

/** The history of states that follow each other at these times. */
function historyOf(...steps: [number, Partial<PageState>, string?][]) {
  let state = opening;
  let history = noHistory;
  for (const [now, parts, as] of steps) {
    const next = { ...state, ...parts };
    history = recorded(history, state, next, as === undefined ? {} : { as }, now);
    state = next;
  }
  return history;
}

test("typing is one step until it rests for a second", () => {
  const history = historyOf(
    [0, { quaternion: "1" }],
    [900, { quaternion: "1 0" }],
    [1800, { quaternion: "1 0 0" }],
    [2801, { quaternion: "1 0 0 0" }],
    [2802, { vector: "1" }],
  );
  expect(history.done.map(({ before }) => before)).toEqual([
    { quaternion: opening.quaternion },
    { quaternion: "1 0 0" },
    { vector: opening.vector },
  ]);
});

test("choices are steps of their own, and a doing lasts as long as it says", () => {
  const chosen = historyOf(
    [0, { preset: "jpl" }],
    [1, { preset: "hamilton" }],
    [2, { digits: "all" }],
    [3, { view: "compose" }],
  );
  expect(chosen.done).toHaveLength(2);
  const drag = { as: "turning", restMs: Number.POSITIVE_INFINITY };
  let history = recorded(noHistory, opening, { ...opening, quaternion: "1" }, drag, 0);
  history = recorded(
    history,
    { ...opening, quaternion: "1" },
    { ...opening, quaternion: "2", vector: "3" },
    drag,
    60_000,
  );
  expect(history.done).toHaveLength(1);
  expect(undone(history, "read")?.change).toEqual({
    quaternion: opening.quaternion,
    vector: opening.vector,
  });
  const next = { ...opening, quaternion: "4" };
  expect(recorded(closed(history), opening, next, drag, 60_001).done).toHaveLength(2);
});

test("undo and redo go through the steps of one view, and a change ends redo", () => {
  const history = historyOf(
    [0, { quaternion: "a" }],
    [0, { view: "compose", p: "b" }],
    [0, { vector: "c" }],
  );
  const back = undone(history, "read");
  expect(back?.change).toEqual({ quaternion: opening.quaternion });
  expect(undone(history, "translate")).toBeUndefined();
  const again = back && redone(back.history, "read");
  expect(again?.change).toEqual({ quaternion: "a" });
  expect(back && redone(back.history, "compose")).toBeUndefined();
  expect(again && undone(again.history, "read")?.change).toEqual(back?.change);
  const changed = back && recorded(back.history, opening, { ...opening, quaternion: "d" }, {}, 0);
  expect(changed?.undone).toEqual([]);
});

test("what was changed and changed back is no step, and two hundred steps are kept", () => {
  expect(historyOf([0, { quaternion: "a" }], [1, { quaternion: opening.quaternion }]).done).toEqual(
    [],
  );
  const many = historyOf(
    ...Array.from({ length: 300 }, (_, at): [number, Partial<PageState>] => [
      at * 2000,
      { quaternion: `${at}` },
    ]),
  );
  expect(many.done).toHaveLength(200);
  expect(many.done[0]?.after).toEqual({ quaternion: "100" });
});
