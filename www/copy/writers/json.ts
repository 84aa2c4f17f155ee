// JSON: the numbers alone, or a test vector that says of itself what another program needs.
import { namesOf } from "../../model/component_order.ts";
import type { Copied, CopiedQuaternion } from "../../model/copied.ts";
import { isNormOne } from "../../number/format.ts";
import {
  directionWords,
  productWords,
  says,
  sequenceLetters,
  takesWords,
} from "../../words/copy/comments.ts";
import { ordered } from "./numbers.ts";

/** Where a copied value comes from. */
export interface Origin {
  /** Of quatlas. */
  version: string;
  /** What was typed, by field; absent where the value is that of an earlier text. */
  source?: Readonly<Record<string, string>>;
  link?: string;
}

/** The numbers by name, on one line. */
export function json(value: Copied): string {
  const comment = says(value, "json").join("; ");
  return JSON.stringify({ comment, ...numbersOf(value) }, null, 1).replace(/\n\s*/g, " ");
}

function numbersOf(value: Copied): object {
  switch (value.kind) {
    case "quaternion": {
      const { components, convention } = value;
      return Object.fromEntries(namesOf[convention.order].map((name) => [name, components[name]]));
    }
    case "matrix":
      return { rows: value.rows };
    case "vector": {
      const [x, y, z] = value.numbers;
      return value.numbers.length === 3 ? { x, y, z } : { numbers: value.numbers };
    }
    case "axis-angle":
      return { axis: value.axis, angle: value.angleRad, unit: "rad" };
    case "rotation-vector":
      return { rotvec: value.vectorRad, unit: "rad" };
    case "euler":
      return {
        sequence: sequenceLetters(value),
        frame: value.sequence.frame,
        angles: value.anglesRad,
        unit: "rad",
      };
  }
}

/** The version of what a test vector looks like; a change of meaning counts it up. */
const testVectorVersion = 1;

export function testVector(value: Copied, origin: Origin): string {
  const { version, ...from } = origin;
  const vector = {
    testVector: testVectorVersion,
    quatlas: version,
    kind: value.kind,
    is: says(value, "test-vector").join("; "),
    ...(value.kind === "quaternion" ? quaternionVector(value) : { numbers: numbersOf(value) }),
    ...from,
  };
  // Numbers of one row stand on one line.
  return JSON.stringify(vector, null, 2).replace(
    /\[\n\s+([^[\]{}"]*?)\n\s+\]/g,
    (_, row: string) => `[${row.replace(/\n\s+/g, " ")}]`,
  );
}

function quaternionVector(value: CopiedQuaternion) {
  const { convention, operator, matrix, norm } = value;
  // The matrix is that of q/|q|, whatever the norm.
  const q = isNormOne(norm) ? "q" : "q/|q|";
  return {
    convention: { ...convention, product: productWords[convention.handedness] },
    numbers: numbersOf(value),
    array: ordered(value).numbers,
    ...(matrix && {
      expected: {
        matrix,
        form: convention.handedness === "right" ? `R(${q})` : `C(${q}) = R(${q})^T`,
        direction: directionWords[operator],
        takes: takesWords[operator],
      },
    }),
  };
}
