// What a text was read as: a quaternion or another description of an attitude.
import type { ReadQuaternion } from "../../engine.ts";
import { operatorOf } from "../../model/conventions.ts";
import { sequenceName } from "../../model/euler_sequence.ts";
import type { Digits, Unit } from "../../model/page_state.ts";
import { fromRadians, shown, shownAngle, shownArray, shownAxis } from "../../number/format.ts";
import { arrowOf } from "../../words/conventions.ts";
import * as words from "../../words/parts/read_as.tsx";
import { namesInOrder } from "./Value.tsx";
import "./read_as.css";

/** `Euler angles ZYX 30°, 20°, 10°` and the like; nothing for a quaternion, whose numbers follow. */
export function FormWords({
  quaternion,
  digits,
  unit,
}: {
  quaternion: ReadQuaternion;
  digits: Digits;
  unit: Unit;
}) {
  const { form } = quaternion;
  const angle = (radians: number) => shownAngle(fromRadians(radians), digits, unit);
  switch (form.kind) {
    case "quaternion":
      return null;
    case "axis-angle":
      return words.axisAngle(
        <code>{angle(form.angleRad)}</code>,
        <code>{shownAxis(form.axis, digits)}</code>,
      );
    case "rotation-vector":
      return words.rotationVector(<code>{shownArray(form.vectorRad, digits)}</code>);
    case "half-angle-vector":
      return words.halfAngleVector(<code>{shownArray(form.vectorRad, digits)}</code>);
    case "gibbs-vector":
      return words.gibbsVector(<code>{shownArray(form.vector, digits)}</code>);
    case "modified-rodrigues":
      return words.modifiedRodrigues(<code>{shownArray(form.parameters, digits)}</code>);
    case "euler-angles": {
      const { sequence, anglesRad } = form;
      return words.euler(
        sequenceName(sequence),
        sequence.frame,
        <code>{anglesRad.map(angle).join(", ")}</code>,
      );
    }
    case "matrix":
      return <>{words.matrix(arrowOf(operatorOf(form.convention)))}</>;
  }
}

/** How the text was read, and the four numbers in the declared convention. */
export function NamedComponents({
  quaternion,
  digits,
  unit,
}: {
  quaternion: ReadQuaternion;
  digits: Digits;
  unit: Unit;
}) {
  const { components, convention } = quaternion;
  return (
    <span class="named-components">
      <FormWords quaternion={quaternion} digits={digits} unit={unit} />
      {namesInOrder(convention).map((name) => (
        <span key={name} class="read-as-part">
          {name} <code>{shown(components[name], digits)}</code>
        </span>
      ))}
    </span>
  );
}
