// The line of the convention and its five choices.

export const more = "Convention";
export const choices = "(5 choices)";
