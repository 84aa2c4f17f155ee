// The address is the state: everything typed and chosen, in the fragment.
import type { Convention, EulerAxes, EulerSequence, MatrixConvention } from "./engine.ts";

export type View = "read" | "compose";
export type Preset = "hamilton" | "jpl";
/** Decimals shown; a copy always has all of them. */
export type Digits = "4" | "6" | "all";

export interface PageState {
  view: View;
  preset: Preset;
  /** The axes in which the declared convention differs from the preset. */
  axes: Partial<Convention>;
  /** How nine typed numbers are read. */
  matrix: MatrixConvention;
  /** The sequence in which Euler angles are shown. */
  euler: EulerSequence;
  digits: Digits;
  /** Texts as typed. */
  quaternion: string;
  p: string;
  q: string;
  vector: string;
}

/** The page opens on the example of the ME 495 lecture: 45° about z, and the point (1, 1, 0)/√2. */
export const opening: PageState = {
  view: "read",
  preset: "hamilton",
  axes: {},
  matrix: { function: "passive", direction: "body-to-world" },
  euler: { axes: "zyx", frame: "intrinsic" },
  digits: "6",
  quaternion: "cos(pi/8) + sin(pi/8) k",
  p: "cos(pi/8) + sin(pi/8) k",
  q: "1/√2 + 1/√2 i",
  vector: "1/√2, 1/√2, 0",
};

/** The values of each axis, as the fragment and the core name them. */
export const axisValues = {
  order: ["scalar-first", "scalar-last"],
  handedness: ["right", "left"],
  function: ["passive", "active"],
  direction: ["body-to-world", "world-to-body"],
  perturbation: ["local", "global"],
} as const satisfies { [Axis in keyof Convention]: readonly Convention[Axis][] };

export type Axis = keyof typeof axisValues;
export const axes = Object.keys(axisValues) as Axis[];

/** The twelve sequences: three different axes, then those that end as they begin. */
export const eulerAxes = [
  ...["xyz", "xzy", "yxz", "yzx", "zxy", "zyx"],
  ...["xyx", "xzx", "yxy", "yzy", "zxz", "zyz"],
] as EulerAxes[];

/** `ZYX` about the moving axes, `zyx` about the fixed ones, as SciPy writes them. */
export function sequenceName({ axes: letters, frame }: EulerSequence): string {
  return frame === "intrinsic" ? letters.toUpperCase() : letters;
}

const texts = ["quaternion", "p", "q", "vector"] as const;

/** The fragment of a state, without `#`. What is as at the opening is left out. */
export function toFragment(state: PageState): string {
  const parameters = new URLSearchParams();
  for (const name of texts) {
    if (state[name] !== opening[name]) parameters.set(name, state[name]);
  }
  if (state.preset !== opening.preset) parameters.set("as", state.preset);
  for (const axis of axes) {
    const value = state.axes[axis];
    if (value !== undefined) parameters.set(axis, value);
  }
  const { matrix, euler } = state;
  if (matrix.function !== opening.matrix.function) parameters.set("matrix", matrix.function);
  if (matrix.direction !== opening.matrix.direction) parameters.set("rows", matrix.direction);
  if (sequenceName(euler) !== sequenceName(opening.euler)) {
    parameters.set("euler", sequenceName(euler));
  }
  if (state.digits !== opening.digits) parameters.set("digits", state.digits);
  const query = parameters.toString();
  return query === "" ? state.view : `${state.view}?${query}`;
}

/** The state of a fragment, with or without `#`; what it does not say is as at the opening. */
export function fromFragment(fragment: string): PageState {
  const [view = "", query = ""] = splitOnce(fragment.replace(/^#/, ""), "?");
  const parameters = new URLSearchParams(query);
  const state: PageState = {
    ...opening,
    view: oneOf(["read", "compose"], view) ?? opening.view,
    preset: oneOf(["hamilton", "jpl"], parameters.get("as")) ?? opening.preset,
    axes: axesFrom(parameters),
    matrix: {
      function: oneOf(axisValues.function, parameters.get("matrix")) ?? opening.matrix.function,
      direction: oneOf(axisValues.direction, parameters.get("rows")) ?? opening.matrix.direction,
    },
    euler: sequenceFrom(parameters.get("euler")) ?? opening.euler,
    digits: oneOf(["4", "6", "all"], parameters.get("digits")) ?? opening.digits,
  };
  for (const name of texts) state[name] = parameters.get(name) ?? opening[name];
  return state;
}

function axesFrom(parameters: URLSearchParams): Partial<Convention> {
  const found = axes.flatMap((axis) => {
    const value = oneOf<string>(axisValues[axis], parameters.get(axis));
    return value === undefined ? [] : [[axis, value]];
  });
  return Object.fromEntries(found);
}

function sequenceFrom(name: string | null): EulerSequence | undefined {
  const letters = oneOf(eulerAxes, name?.toLowerCase() ?? null);
  const frames = ["intrinsic", "extrinsic"] as const;
  return (
    letters &&
    frames
      .map((frame) => ({ axes: letters, frame }))
      .find((sequence) => sequenceName(sequence) === name)
  );
}

function splitOnce(text: string, mark: string): string[] {
  const at = text.indexOf(mark);
  return at < 0 ? [text] : [text.slice(0, at), text.slice(at + mark.length)];
}

function oneOf<Name extends string>(names: readonly Name[], text: string | null): Name | undefined {
  return names.find((name) => name === text);
}
