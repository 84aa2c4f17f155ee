// How a product is translated.
import type { Direction, Side, TranslatedEnd } from "../../engine.ts";
import { notEstablished } from "../library_behaviour.ts";
import type { EndNames } from "./translate.ts";

export const title = "A product";
export const becomes = "becomes";

export const neither = (
  <>
    The axes of the world and of the body change differently. So the product of two translated
    attitudes is <strong>neither of the two products</strong>: multiply first, then translate the
    result.
  </>
);

export const unknown = (identifyAddress: string) => (
  <>
    The product of one of the two is {notEstablished}; a message has none of its own, only the
    library that reads it. With what a library prints, <a href={identifyAddress}>Identify</a> finds
    out.
  </>
);

/** Which operand acts first at either end, whether both lead the same way, and what follows. */
export const operands = (
  from: TranslatedEnd,
  to: TranslatedEnd,
  names: EndNames,
  product: "same" | "reversed",
) => (
  <>
    {from.firstToAct === to.firstToAct
      ? `In both, the ${sideOf(from)} operand acts first on a vector`
      : `In ${names.from} the ${sideOf(from)} operand acts first, in ${names.to} the ${sideOf(to)} one`}
    {from.direction === to.direction
      ? `, and both lead ${wayWords[from.direction]}`
      : `; one leads ${wayWords[from.direction]}, the other back`}
    . So, with <var>a</var> and <var>b</var> translated,{" "}
    <strong>
      {product === "reversed" ? "the operands change places" : "the operands keep their places"}
    </strong>
    .
  </>
);

const wayWords: Record<Direction, string> = {
  "body-to-world": "from body to world",
  "world-to-body": "from world to body",
};

const sides: Record<Side, string> = { left: "left", right: "right" };

const sideOf = ({ firstToAct }: TranslatedEnd) => firstToAct && sides[firstToAct];
