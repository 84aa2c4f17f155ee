// The words of the Compose view.
import type { ComponentChildren } from "preact";

/** A symbol or a formula inside a sentence. */
type Symbols = ComponentChildren;

export const composeWords = {
  input: "Input",
  equals: (one: string, other: string) => `${one} equals ${other}`,
  tie: "the same numbers, transposed matrices",
  /** The operand that acts first, and the other one. */
  firstThen: (first: Symbols, then: Symbols) => (
    <>
      first {first}, then {then}
    </>
  ),
  declared: (product: string) => `${product} as declared`,
  onAxes: (vector: Symbols, frame: string) => (
    <>
      {vector} on the axes of {frame}
    </>
  ),
  afterOnAxes: (operand: Symbols, frame: string) => (
    <>
      after {operand}, on the axes of {frame}
    </>
  ),
  beyond: "beyond a double",
  yours: "your convention",
  meet: (
    convention: string,
    direction: string,
    [right, left]: [Symbols, Symbols],
    [start, middle, end]: [string, string, string],
  ) => (
    <>
      In {convention}, {direction}, {right} leads from {start} to {middle} and {left} from {middle}{" "}
      to {end}: they meet in {middle}. W is the world, B the body, B′ a second body mounted on B.
    </>
  ),
  commute:
    "These two commute: all four products are the same quaternion, so they cannot show which order a program uses.",
  anticommute:
    "Swapped, these two give −1 times the same quaternion: the same rotation, so they cannot show which order a program uses.",
  turns: (first: Symbols, other: Symbols) => (
    <>
      As turns of the body: about the fixed axes first {first}, then {other}; about the moving axes
      first {other}, then {first}.
    </>
  ),
} as const;
