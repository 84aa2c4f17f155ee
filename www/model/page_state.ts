// What a page shows and was asked: every value of its state, and the state it opens with.
import type {
  Convention,
  Endpoint,
  EulerSequence,
  Language,
  MatrixConvention,
  Probe,
  ProbeKind,
} from "../engine.ts";
import { firstPicture, type PictureState } from "./picture_state.ts";

export const views = [
  "read",
  "compose",
  "motion",
  "frames",
  "translate",
  "identify",
  "libraries",
] as const;
export type View = (typeof views)[number];
/** The views that the core of the first load answers. */
export const smallViews: readonly View[] = ["read", "compose"];
export const presetChoices = ["hamilton", "jpl"] as const;
export type Preset = (typeof presetChoices)[number];
/** Decimals shown; a copy always has all of them. */
export const digitChoices = ["4", "6", "all"] as const;
export type Digits = (typeof digitChoices)[number];
/** The unit in which angles are shown. */
export const unitChoices = ["degrees", "radians"] as const;
export type Unit = (typeof unitChoices)[number];

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
  unit: Unit;
  /** Texts as typed. */
  quaternion: string;
  p: string;
  q: string;
  vector: string;
  /** The quaternion of the Translate view. */
  translated: string;
  /** The ends of the translation. */
  from: Endpoint;
  to: Endpoint;
  /** The change of axes on the way; empty where they stay. */
  worldAxes: string;
  bodyAxes: string;
  /** What a library printed. */
  observations: readonly Probe[];
  /** What the observed library is called. */
  libraryName: string;
  /** The language of the code of a probe. */
  language: Language;
  /** The kinds of probes that cannot be run. */
  unavailable: readonly ProbeKind[];
  /** Three, four or nine numbers of which it is asked what they are; empty where nothing is. */
  numbers: string;
  /** The attitude beside them. */
  beside: string;
  /** What a library of matrices printed, as Identify writes it; empty for its example. */
  matrices: string;
  /** The folds that are open of those that ask the whole core, with commas between them. */
  open: string;
  /** The part of the way from p to q. */
  part: string;
  /** The time from p to q, of which the rate is asked; empty where it is not. */
  within: string;
  /** What is multiplied besides p and q, and what is inverted; see `factors.ts` of Compose. */
  factors: string;
  /** The axis of a twist. */
  axis: string;
  /** The angular velocity at the beginning and at the end, how long it goes from one to the other, and a small turn. */
  rate: string;
  rateEnd: string;
  duration: string;
  increment: string;
  /** A covariance, and a point of the body, of which Motion is asked beside these. */
  covariance: string;
  point: string;
  /** The choices of the Motion view, as it writes them. */
  motion: string;
  /** What is asked of named frames, and the poses between them, as the Frames view writes it. */
  frames: string;
  /** How the picture is shown. */
  picture: PictureState;
  /** What the table of libraries is searched for. */
  find: string;
  /** The id of the opened record of the table; empty where none is open. */
  library: string;
}

/**
 * The page opens on the example of the ME 495 lecture: 45° about z, and the point (1, 1, 0)/√2.
 * Translate opens on the log of a filter, and Identify on a library that has JPL's product and
 * is not JPL, as DirectXMath.
 */
export const opening: PageState = {
  view: "read",
  preset: "hamilton",
  axes: {},
  matrix: { function: "passive", direction: "body-to-world" },
  euler: { axes: "zyx", frame: "intrinsic" },
  digits: "6",
  unit: "degrees",
  quaternion: "cos(pi/8) + sin(pi/8) k",
  p: "cos(pi/8) + sin(pi/8) k",
  q: "1/√2 + 1/√2 i",
  vector: "1/√2, 1/√2, 0",
  translated: "0.1 -0.2 0.4 0.888819441731559",
  from: { kind: "library", id: "openvins" },
  to: { kind: "library", id: "ceres" },
  worldAxes: "",
  bodyAxes: "",
  observations: [
    { probe: "product", a: "0 1 0 0", b: "0 0 1 0", printed: "-1 0 0 0" },
    { probe: "rotate", quaternion: "0.5 0.5 0.5 0.5", vector: "1 2 3", printed: "3 1 2" },
    {
      probe: "matrix",
      quaternion: "0.5 0.5 0.5 0.5",
      printed: "0 1 0\n0 0 1\n1 0 0",
      layout: "as-written",
    },
  ],
  libraryName: "X",
  language: "python",
  unavailable: [],
  numbers: "",
  beside: "",
  matrices: "",
  open: "",
  part: "0.5",
  within: "",
  factors: "",
  axis: "z",
  rate: "0.3 -0.2 0.5",
  rateEnd: "0.1 0.4 -0.6",
  duration: "6 s",
  increment: "0.02 -0.03 0.05",
  covariance: "0.4 0.1 -0.2  0.1 0.9 0.3  -0.2 0.3 0.6",
  point: "1 2 3",
  motion: "",
  frames: "",
  picture: firstPicture,
  find: "",
  library: "",
};
