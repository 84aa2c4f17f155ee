// The words of what is folded below the answer.

export const more = "More about this rotation";
export const products = "What each convention multiplies, and the product matrices";
export const paired = "The matrix as chosen beside q";
export const tangents = "Gibbs vector and modified Rodrigues parameters";
