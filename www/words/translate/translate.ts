// The words of the Translate view around its parts, and what a screen reader hears of it.
import type { ComponentOrder, TranslateReport } from "../../engine.ts";
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
export const components = (name: string, order: ComponentOrder) =>
  `q of ${name} as ${lettersOf[order]}`;
export const yours = "Your convention";

/** Where both ends have the same name. */
export const sameNames = (name: string): EndNames => ({
  from: `${name} (from)`,
  to: `${name} (to)`,
});

/** What a screen reader hears when the result changes. */
export const spoken = (name: string, numbers: readonly string[], report: TranslateReport) =>
  `Result for ${name}: ${numbers.join(", ")}. ${changeWords(report)}.`;

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
