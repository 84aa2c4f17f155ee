// The words of what is folded below the answer.

export const more = "More about this rotation";
/** In this order. */
export const parts = ["products", "tangents"] as const;
export type FoldedPart = (typeof parts)[number];
export const lines: Record<FoldedPart, string> = {
  products:
    "What each convention multiplies, the product matrices, and the matrix as chosen beside q",
  tangents: "Gibbs vector and modified Rodrigues parameters; twist and swing",
};

/** Those that ask the whole core. */
export const asked = {
  atlas: "The same rotation in all 16 conventions",
  "swing-twist": "Twist and swing about an axis",
};
