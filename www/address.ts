// The address is the state: everything typed and chosen, in the fragment.

export type View = "read" | "compose";
export type Preset = "hamilton" | "jpl";
/** Decimals shown; a copy always has all of them. */
export type Digits = "4" | "6" | "all";

export interface PageState {
  view: View;
  preset: Preset;
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
  digits: "6",
  quaternion: "cos(pi/8) + sin(pi/8) k",
  p: "cos(pi/8) + sin(pi/8) k",
  q: "1/√2 + 1/√2 i",
  vector: "1/√2, 1/√2, 0",
};

const texts = ["quaternion", "p", "q", "vector"] as const;

/** The fragment of a state, without `#`. What is as at the opening is left out. */
export function toFragment(state: PageState): string {
  const parameters = new URLSearchParams();
  for (const name of texts) {
    if (state[name] !== opening[name]) parameters.set(name, state[name]);
  }
  if (state.preset !== opening.preset) parameters.set("as", state.preset);
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
    digits: oneOf(["4", "6", "all"], parameters.get("digits")) ?? opening.digits,
  };
  for (const name of texts) state[name] = parameters.get(name) ?? opening[name];
  return state;
}

function splitOnce(text: string, mark: string): string[] {
  const at = text.indexOf(mark);
  return at < 0 ? [text] : [text.slice(0, at), text.slice(at + mark.length)];
}

function oneOf<Name extends string>(names: Name[], text: string | null): Name | undefined {
  return names.find((name) => name === text);
}
