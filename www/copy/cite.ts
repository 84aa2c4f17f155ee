// One short sentence that names a case: its convention, its numbers rounded, the version and the link.
import type {
  Components,
  ComposeReport,
  Convention,
  ReadReport,
  TranslateReport,
  Turn,
} from "../engine.ts";
import { isNormOne } from "../number/format.ts";
import { citeWords as words } from "../words/copy/citation.ts";

/** Enough to recognise the case; the link holds every digit. */
const significantDigits = 5;
/** What is this much smaller than the largest number beside it is rounding, not information. */
const roundingNoise = 1e-14;

export function cited(number: number, largest = 0, digits = significantDigits): string {
  const size = Math.abs(number) < roundingNoise * largest ? 0 : number;
  return String(Number(size.toPrecision(digits)));
}

function tuple(numbers: readonly number[], digits = significantDigits): string {
  const largest = Math.max(...numbers.map(Math.abs));
  return `(${numbers.map((number) => cited(number, largest, digits)).join(", ")})`;
}

function quaternion({ norm }: Components, numbers: readonly number[]): string {
  if (isNormOne(norm)) return words.unitQuaternion(tuple(numbers));
  return words.quaternion(tuple(numbers), norm === undefined ? undefined : cited(norm));
}

export function turnOf(
  { axis, angleDeg }: Turn,
  digits = significantDigits,
  axisDigits = digits,
): string {
  if (axis === undefined) return words.noTurn;
  const along = axis.findIndex((number) => Math.abs(number) === 1);
  const name =
    along < 0 ? tuple(axis, axisDigits) : `${(axis[along] ?? 0) < 0 ? "-" : ""}${"xyz"[along]}`;
  return words.turn(`${cited(angleDeg, 0, digits)}°`, name);
}

export function citeRead({ declared, turn }: ReadReport): string {
  const { quaternion: q, convention } = declared;
  return words.read(quaternion(q, q.array), words.convention(convention), turnOf(turn));
}

export const signs: Record<Convention["handedness"], string> = { right: "⊙", left: "⊗" };

export function citeCompose({ declared, p, q }: ComposeReport): string {
  const { convention } = declared;
  return words.compose(
    tuple(p.components.array),
    signs[convention.handedness],
    tuple(q.components.array),
    tuple(declared.quaternion.array),
    words.convention(convention),
  );
}

export function citeTranslation({ from, to, turn }: TranslateReport, names: Ends): string {
  return words.translate(
    quaternion(from.components, from.array),
    names.from,
    names.to,
    tuple(to.array),
    turnOf(turn),
  );
}

/** What the ends of a translation are called. */
export interface Ends {
  from: string;
  to: string;
}

/** A link in Markdown; brackets of the title would end it. */
export function markdownLink(title: string, link: string): string {
  const escaped = title.replace(/\s+/g, " ").replace(/[\\[\]]/g, "\\$&");
  // A parenthesis would end the address.
  const address = link.replaceAll("(", "%28").replaceAll(")", "%29");
  return `[${escaped}](${address})`;
}
