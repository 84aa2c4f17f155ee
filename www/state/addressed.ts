// The state as the address holds it: what is pasted whole makes no endless address.
import type { Convention, Engine, ReadQuaternion } from "../engine.ts";
import { axes, declaredConvention } from "../model/conventions.ts";
import type { PageState } from "../model/page_state.ts";

/** The longest text that the address holds as it is, in characters. */
const longestInAddress = 8192;

type Answer = ReturnType<Engine["analyze"]> | undefined;

/** The texts of rotations. */
const rotationTexts = ["quaternion", "p", "q", "translated"] as const;

/**
 * The state with the numbers that were read in place of each text that is too long for an address; the
 * state itself where there is none.
 */
export function addressed(state: PageState, answer: Answer): PageState {
  let shortened = state;
  for (const name of rotationTexts) {
    if (state[name].length <= longestInAddress) continue;
    const read = readOf(name, answer);
    const told = read && axesToTell(state, name, read.convention);
    if (read === undefined || told === undefined) continue;
    const declaredAxes = { ...shortened.axes, ...told };
    shortened = { ...shortened, [name]: namedNumbers(read), axes: declaredAxes };
  }
  return shortened;
}

function readOf(name: (typeof rotationTexts)[number], answer: Answer): ReadQuaternion | undefined {
  switch (answer?.status) {
    case "read":
      return name === "quaternion" ? answer.quaternion : undefined;
    case "compose":
      return name === "p" || name === "q" ? answer[name] : undefined;
    case "translate":
      return name === "translated" ? answer.quaternion : undefined;
    default:
      return undefined;
  }
}

/**
 * What of the convention that a text told must be declared for the numbers alone; `undefined` where that
 * would change another text. The names tell the order.
 */
function axesToTell(
  state: PageState,
  name: (typeof rotationTexts)[number],
  { order: _, ...used }: Convention,
): Partial<Convention> | undefined {
  const declared = declaredConvention(state);
  const told = axes.filter((axis) => axis !== "order" && used[axis] !== declared[axis]);
  if (name === "translated" || told.length === 0) return {};
  return name === "quaternion"
    ? Object.fromEntries(told.map((axis) => [axis, used[axis as keyof typeof used]]))
    : undefined;
}

function namedNumbers({ components: { w, x, y, z } }: ReadQuaternion): string {
  return `w=${w} x=${x} y=${y} z=${z}`;
}
