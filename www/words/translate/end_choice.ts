// The words with which the ends of a translation are chosen.

export const side = { from: "From", to: "To" };
export const record = "its record";
export const takes = (action: string) => `Its ${action}(q) takes`;

export const numbersTake = "Its rotation takes";

/** How a direction is known. */
export const documented = "documented";
export const assumed = "assumed";
export const customary = "customary";
export const order = "Its numbers stand as";
export const printed = "as it prints them";
export const ofArray = "its array";
export const ofConstructor = "its constructor";
export const five = "The five axes";
