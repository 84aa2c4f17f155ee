// The address is the state: everything typed and chosen, in the fragment.
import type { Convention, Endpoint, EulerSequence, Probe } from "../engine.ts";
import { axes, axisValues } from "../model/conventions.ts";
import { sequenceName } from "../model/euler_sequence.ts";
import type { PageState, Unit } from "../model/page_state.ts";
import { digitChoices, opening, presetChoices, unitChoices, views } from "../model/page_state.ts";
import { mostObservations } from "../model/probes.ts";
import { eulerAxesValues, eulerFrameValues, languageValues, probeKindValues } from "../values.ts";
import { endFromText, endToText, type IsLibrary } from "./ends.ts";
import { pictureFrom, pictureToTexts } from "./picture.ts";
import { probeFromText, probeToText } from "./probes.ts";

/** The texts and their names in the fragment. */
const texts = {
  quaternion: "quaternion",
  p: "p",
  q: "q",
  vector: "vector",
  translated: "translated",
  worldAxes: "world",
  bodyAxes: "body",
  libraryName: "name",
  numbers: "numbers",
  beside: "beside",
  matrices: "matrices",
  open: "open",
  part: "part",
  within: "within",
  factors: "factors",
  axis: "axis",
  frames: "frames",
  rate: "rate",
  rateEnd: "to-rate",
  duration: "in",
  increment: "increment",
  covariance: "covariance",
  point: "point",
  motion: "motion",
  find: "find",
  library: "library",
} as const satisfies Partial<Record<keyof PageState, string>>;
type Text = keyof typeof texts;

/**
 * What the parameters mean, as `v` in front of them; without it 1. A new parameter, or a new value of
 * one, leaves it as it is. A change of what an old link would mean (a default, the opening example,
 * the name or sense of a value) counts it up, and `fromFragment` then first rewrites the parameters of
 * each older version into those of the next, so that the old link still opens the same page.
 */
const addressVersion = 1;
const versionParameter = "v";

/** Whether a link was written by a later version, so that it may say what is not known here. */
export function isOfNewerVersion(fragment: string): boolean {
  const [, query = ""] = splitOnce(fragment, "?");
  const version = new URLSearchParams(query).get(versionParameter) ?? "";
  return /^\d+$/.test(version) && Number(version) > addressVersion;
}
/** The units as the fragment names them, and as they are typed. */
const unitNames: Record<Unit, string> = { degrees: "deg", radians: "rad" };

/** Marks that an address may hold as they are. */
const plainMarks = /%(?:3A|3B|2C|7E)/g;

const version = `${versionParameter}=${addressVersion}`;

/** The fragment of a state for others, which says its version even where all is as at the opening. */
export function versionedFragment(state: PageState): string {
  const fragment = toFragment(state);
  return fragment.includes("?") ? fragment : `${fragment}?${version}`;
}

/** The fragment of a state, without `#`. What is as at the opening is left out. */
export function toFragment(state: PageState): string {
  const parameters = new URLSearchParams();
  for (const [name, parameter] of Object.entries(texts) as [Text, string][]) {
    if (state[name] !== opening[name]) parameters.set(parameter, state[name]);
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
  if (state.unit !== opening.unit) parameters.set("unit", unitNames[state.unit]);
  for (const end of ["from", "to"] as const) {
    const text = endToText(state[end]);
    if (text !== endToText(opening[end])) parameters.set(end, text);
  }
  for (const [name, text] of pictureToTexts(state.picture)) parameters.set(name, text);
  for (const probe of probesToTexts(state.observations)) parameters.append("probe", probe);
  if (state.language !== opening.language) parameters.set("language", state.language);
  if (state.unavailable.length > 0) parameters.set("unavailable", state.unavailable.join(","));
  const query = parameters.toString().replace(plainMarks, decodeURIComponent);
  return query === "" ? state.view : `${state.view}?${version}&${query}`;
}

/** The observations as parameters; none where they are those of the opening, an empty one for none. */
function probesToTexts(observations: readonly Probe[]): string[] {
  const written = observations.map(probeToText);
  const first = opening.observations.map(probeToText);
  const isOpening =
    written.length === first.length && written.every((text, at) => text === first[at]);
  if (isOpening) return [];
  return written.length === 0 ? [""] : written;
}

/** The state of a fragment, with or without `#`; what it does not say is as at the opening. */
export function fromFragment(fragment: string, isLibrary: IsLibrary = () => true): PageState {
  const [view = "", query = ""] = splitOnce(fragment.replace(/^#/, ""), "?");
  const parameters = new URLSearchParams(query);
  const state: PageState = {
    ...opening,
    view: oneOf(views, view) ?? opening.view,
    preset: oneOf(presetChoices, parameters.get("as")) ?? opening.preset,
    axes: axesFrom(parameters),
    matrix: {
      function: oneOf(axisValues.function, parameters.get("matrix")) ?? opening.matrix.function,
      direction: oneOf(axisValues.direction, parameters.get("rows")) ?? opening.matrix.direction,
    },
    euler: sequenceFrom(parameters.get("euler")) ?? opening.euler,
    digits: oneOf(digitChoices, parameters.get("digits")) ?? opening.digits,
    unit: unitChoices.find((unit) => unitNames[unit] === parameters.get("unit")) ?? opening.unit,
    from: endFromText(parameters.get("from"), isLibrary) ?? opening.from,
    to: endFromText(parameters.get("to"), isLibrary) ?? opening.to,
    observations: probesFrom(parameters),
    picture: pictureFrom(parameters),
    language: oneOf(languageValues, parameters.get("language")) ?? opening.language,
    unavailable: probeKindValues.filter((kind) =>
      parameters.get("unavailable")?.split(",").includes(kind),
    ),
  };
  for (const [name, parameter] of Object.entries(texts) as [Text, string][]) {
    state[name] = parameters.get(parameter) ?? opening[name];
  }
  if (!isLibrary(state.library)) state.library = opening.library;
  return state;
}

/** The state with the ends and the record of the opening in place of libraries that there are not. */
export function withKnownLibraries(state: PageState, isLibrary: IsLibrary): PageState {
  const isKnown = (end: Endpoint) => end.kind !== "library" || isLibrary(end.id);
  const { from, to, library } = state;
  if (isKnown(from) && isKnown(to) && (library === "" || isLibrary(library))) return state;
  return {
    ...state,
    from: isKnown(from) ? from : opening.from,
    to: isKnown(to) ? to : opening.to,
    library: isLibrary(library) ? library : opening.library,
  };
}

function probesFrom(parameters: URLSearchParams): readonly Probe[] {
  const written = parameters.getAll("probe").slice(0, mostObservations);
  const read = written.map(probeFromText).filter((probe) => probe !== undefined);
  const isEmptied = written.length === 1 && written[0] === "";
  return read.length > 0 || isEmptied ? read : opening.observations;
}

function axesFrom(parameters: URLSearchParams): Partial<Convention> {
  const found = axes.flatMap((axis) => {
    const value = oneOf<string>(axisValues[axis], parameters.get(axis));
    return value === undefined ? [] : [[axis, value]];
  });
  return Object.fromEntries(found);
}

function sequenceFrom(name: string | null): EulerSequence | undefined {
  const letters = oneOf(eulerAxesValues, name?.toLowerCase() ?? null);
  return (
    letters &&
    eulerFrameValues
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
