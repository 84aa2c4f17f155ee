// The words of the Translate view around its parts, and what a screen reader hears of it.
import type { ComponentOrder, RecordNumbersKind, TranslateReport } from "../../engine.ts";
import { lettersOf } from "../conventions.ts";

/** What the two ends are called. */
export interface EndNames {
  from: string;
  to: string;
}

export const input = "Input";
export const swap = "Swap sides";
export const examples = "Examples";

export const exampleNames = {
  ceres: "A JPL filter log to Ceres",
  px4: "PX4 to ROS",
  matlab: "MATLAB Aerospace to SciPy",
  camera: "World to camera, to Eigen",
  directx: "DirectXMath to GLM",
  unity: "ROS to Unity",
};

export const readAs = "Read as";
export const looksLike = (name: string) => `This looks like ${name}:`;
export const translateFrom = (name: string) => `translate from ${name}`;
export const asPrinted = (name: string, printed: ComponentOrder, stored: ComponentOrder) =>
  `${name} prints ${lettersOf[printed]} and stores ${lettersOf[stored]}: read as printed.`;
export const oneIsLeftHanded = (name: string) =>
  `The axes of ${name} are left-handed: where the other end's are not, the axes change, too.`;
export const components = (name: string, order: ComponentOrder) =>
  `q of ${name} as ${lettersOf[order]}`;
export const yours = "Your convention";

/** Where both ends have the same name. */
export const sameNames = (name: string): EndNames => ({
  from: `${name} (from)`,
  to: `${name} (to)`,
});

/** What a screen reader hears when the result changes. */
export const spoken = (name: string, numbers: readonly string[], change: string) =>
  `Result for ${name}: ${numbers.join(", ")}. ${change}.`;

/** `From Euler angles to a rotation vector`. */
export function numbersChange({ from, to, axes }: TranslateReport): string {
  const [one, other] = [from, to].map(({ numbers }) => writtenAs[numbers?.kind ?? "quaternion"]);
  return `From ${one} to ${other}${axes ? ", and on other axes" : ""}`;
}

const writtenAs: Record<RecordNumbersKind | "quaternion", string> = {
  quaternion: "a quaternion",
  "euler-angles": "Euler angles",
  "rotation-vector": "a rotation vector",
  "axis-angle": "axis and angle",
  matrix: "a matrix",
};

/** `Reordered, not conjugated` and the like. */
export function changeWords({ change, axes }: TranslateReport): string {
  const words = {
    copied: "Neither reordered nor conjugated",
    reordered: "Reordered, not conjugated",
    conjugated: "Conjugated, not reordered",
    "reordered-and-conjugated": "Reordered and conjugated",
  }[change];
  return axes ? `${words}, and on other axes` : words;
}
