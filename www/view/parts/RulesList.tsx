// What a convention multiplies in which order, and which formula makes a matrix of its numbers.
import type { ComponentChildren } from "preact";
import type { Convention, CosineMatrix, Rules, Side } from "../../engine.ts";
import * as words from "../../words/parts/rules_list.tsx";
import "./rules_list.css";

/** `R(q)` or `C(q)`. */
export function MatrixOf({ form }: { form: CosineMatrix }) {
  return (
    <>
      <var>{form}</var>(<var>q</var>)
    </>
  );
}

/** What the convention multiplies in which order. */
export function RulesList({
  name,
  rules,
  perturbation,
  children,
}: {
  name: string;
  rules: Rules;
  perturbation: Convention["perturbation"];
  /** What is said before. */
  children?: ComponentChildren;
}) {
  return (
    <ul class="rules" aria-label={name}>
      {children}
      <li>
        {words.labels(
          <Product first={<Q of="AB" />} second={<Q of="BC" />} side={rules.labelledFirst} />,
          <Q of="AC" />,
        )}
      </li>
      <li>
        {words.camera(
          <Product first={<Q of="WB" />} second={<Q of="BC" />} side={rules.chainFirst} />,
        )}
      </li>
      <li>
        {words.increment[perturbation](
          <Product first={<var>δq</var>} second={<var>q</var>} side={rules.increment} />,
        )}
      </li>
      <li>
        {words.bodyRate(
          <>
            <var>q̇</var> = {rules.isCanonical ? "½" : "−½"}{" "}
            <Product first={<var>ω</var>} second={<var>q</var>} side={rules.bodyRate} />
          </>,
        )}
      </li>
    </ul>
  );
}

function Q({ of }: { of: string }) {
  return (
    <>
      <var>q</var>
      <sub>{of}</sub>
    </>
  );
}

/** Two factors, the first of them on this side. */
function Product({
  first,
  second,
  side,
}: {
  first: ComponentChildren;
  second: ComponentChildren;
  side: Side;
}) {
  const [left, right] = side === "left" ? [first, second] : [second, first];
  return (
    <span class="factors">
      {left}∘{right}
    </span>
  );
}
