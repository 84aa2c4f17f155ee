// How a product is written, and how its numbers are shown.
import type { Engine, Frame, Handedness, Product } from "../../engine.ts";
import type { Digits, Unit } from "../../model/page_state.ts";

/** How the numbers of a product are shown. */
export interface ShownAs {
  engine: Engine;
  /** The product that has the badge. */
  declared: Product;
  digits: Digits;
  unit: Unit;
}

const signOf: Record<Handedness, string> = { right: "⊙", left: "⊗" };
const letterOf: Record<Frame, string> = { world: "W", body: "B", "second-body": "B′" };

export function spelled({ left, right, convention }: Product): string {
  return `${left} ${signOf[convention.handedness]} ${right}`;
}

/** The letters of the frames on the way of a vector. */
export function framesOf({ frames: [start, middle, end] }: Product): [string, string, string] {
  return [letterOf[start], letterOf[middle], letterOf[end]];
}

export function Formula({ product }: { product: Product }) {
  return (
    <>
      <var>{product.left}</var> {signOf[product.convention.handedness]} <var>{product.right}</var>
    </>
  );
}
