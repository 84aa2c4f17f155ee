// The factors of a chain as one text of the address; pure.
import type { PageState } from "../../model/page_state.ts";

/** A text, and whether its inverse stands in the product. */
export interface Factor {
  text: string;
  inverse: boolean;
}

/** As many are multiplied, p and q included. */
export const mostFactors = 32;

const separator = "~";
const inverted = "/";
const reversed = "r";

/**
 * The factors that a state means: p, q and those that were added. Its text is `p` and `q` where these are
 * inverted, `r` where all are multiplied in reverse, and each of the others after a `~`, with a `/` in front where it is inverted.
 */
export function factorsOf({ p, q, factors }: PageState): Factor[] {
  const [flags = "", ...added] = factors.split(separator);
  return [
    { text: p, inverse: flags.includes("p") },
    { text: q, inverse: flags.includes("q") },
    ...added.slice(0, mostFactors - 2).map((written) => ({
      text: written.startsWith(inverted) ? written.slice(1) : written,
      inverse: written.startsWith(inverted),
    })),
  ];
}

/** Whether the factors are multiplied in reverse. */
export const isReversed = ({ factors }: PageState) =>
  factors.split(separator, 1)[0]?.includes(reversed) === true;

/** The text of factors, without what p and q are. */
export function factorsText([p, q, ...added]: readonly Factor[], inReverse: boolean): string {
  const flags = `${p?.inverse ? "p" : ""}${q?.inverse ? "q" : ""}${inReverse ? reversed : ""}`;
  const written = added.map(
    ({ text, inverse }) => `${inverse ? inverted : ""}${text.replaceAll(separator, " ")}`,
  );
  return [flags, ...written].join(separator);
}
