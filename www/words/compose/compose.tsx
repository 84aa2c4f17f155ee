// The words of the Compose view.
import type { ComponentChildren } from "preact";

/** A symbol or a formula inside a sentence. */
type Symbols = ComponentChildren;

export const input = "Input";
/** Between two products, for who does not see the sign. */
export const equals = "equals";
export const tie = "the same numbers, transposed matrices";
/** Where the declared convention is neither preset. */
export const tieOfPresets = "the same rotation in the presets, with transposed matrices";
/** Where there is room for one. */
export const shownProduct = "Shown in";

/** The operand that acts first, and the other one. */
export const firstThen = (first: Symbols, then: Symbols) => (
  <>
    first {first}, then {then}
  </>
);

export const rotation = "rotation";
export const noRotation = "none: 0°";
/** Between an angle and an axis. */
export const about = "about";
export const otherOrder = (products: string) => `The other order: ${products}`;

export const forms = (product: string) =>
  `${product} as rotation vector and Euler angles, and its inverse`;
export const between = "Between p and q: how they differ, and the way from one to the other";
export const chain = "More than two: a product of any factors, inverted or not, and their mean";

export const declared = (product: string) => `${product} as declared`;

export const onAxes = (vector: Symbols, frame: string) => (
  <>
    {vector} on the axes of {frame}
  </>
);

export const afterOnAxes = (operand: Symbols, frame: string) => (
  <>
    after {operand}, on the axes of {frame}
  </>
);

export const beyond = "beyond the range of a double";
/** Inside a sentence, and as a name. */
export const yours = "your convention";
export const yourConvention = "Your convention";

/** What the matrices of a convention do: an active one has that of the other direction. */
export const matricesDo = {
  passive: (arrow: string) => arrow,
  active: (arrow: string) => `which turns vectors by the matrices ${arrow}`,
};

export const meet = (
  convention: string,
  direction: string,
  [right, left]: [Symbols, Symbols],
  [start, middle, end]: [string, string, string],
) => (
  <>
    In {convention}, {direction}, {right} leads from {start} to {middle} and {left} from {middle} to{" "}
    {end}: they meet in {middle}. W is the world, B the body, B′ a second body mounted on B.
  </>
);

export const commute =
  "These two commute: all four products are the same quaternion, so they cannot show which order a program uses.";

export const anticommute =
  "Swapped, these two give −1 times the same quaternion: the same rotation, so they cannot show which order a program uses.";

export const turns = (first: Symbols, other: Symbols) => (
  <>
    As rotations of the body: about the fixed axes first {first}, then {other}; about the moving
    axes first {other}, then {first}.
  </>
);

export const spokenProduct = (convention: string, numbers: readonly string[]) =>
  `Result: p times q in ${convention}: ${numbers.join(", ")}.`;
