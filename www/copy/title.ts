// A case in a few words, for the title of the tab and for a link to it. Everything is rounded to what
// a case is recognised by.
import type {
  ComposeReport,
  Engine,
  MotionReport,
  ReadReport,
  TranslateReport,
} from "../engine.ts";
import { titleWords as words } from "../words/copy/title.ts";
import { cited, type Ends, signs, turnOf } from "./cite.ts";

const significantDigits = 4;
const digitsOfAxis = 3;

const withMinus = (text: string) => text.replaceAll("-", "−");

function numbers(all: readonly number[]): string {
  const largest = Math.max(...all.map(Math.abs));
  return withMinus(all.map((number) => cited(number, largest, significantDigits)).join(" "));
}

/** `44.96° about z · JPL 0.02 −0.01 0.38 0.92`. */
export function readTitle({ declared, turn }: ReadReport, { describe }: Engine): string {
  const { convention, quaternion } = declared;
  const { preset } = describe(convention);
  const name = words.convention(preset, convention.order);
  const turned = withMinus(turnOf(turn, significantDigits, digitsOfAxis));
  return words.read(turned, name, numbers(quaternion.array));
}

/** `p ⊙ q = 0.6533 0.6533 0.2706 0.2706 · Hamilton`. */
export function composeTitle({ declared }: ComposeReport, { describe }: Engine): string {
  const { convention, quaternion, left, right } = declared;
  const { preset } = describe(convention);
  return words.compose(
    `${left} ${signs[convention.handedness]} ${right}`,
    numbers(quaternion.array),
    words.convention(preset, convention.order),
  );
}

/** `Hamilton 0.9239 0 0 0.3827 · ω 0.3 −0.2 0.5 rad/s`, on the body's axes; none where no rate was given. */
export function motionTitle(
  { quaternion, derivative }: MotionReport,
  { describe }: Engine,
): string | undefined {
  const { components, convention } = quaternion;
  const { preset } = describe(convention);
  return (
    derivative &&
    words.motion(
      words.convention(preset, convention.order),
      numbers(components.array),
      numbers(derivative.bodyRad),
    )
  );
}

/** `OpenVINS → Eigen · 0.1 −0.2 0.4 0.8888`. */
export function translateTitle({ to }: TranslateReport, names: Ends): string {
  return words.translate(names.from, names.to, numbers(to.array));
}
