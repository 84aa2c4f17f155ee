// What libraries do: the table, as it stands beside the core.
import type { Library } from "../../pkg/quatlas.js";
import table from "../../src/library/libraries.json";

/**
 * What libraries do with four numbers, and how that is known: one record a library and version.
 *
 * What a record leaves out is not established. The same table is in `quatlas/libraries.json`, and what
 * each library printed when it was run in `quatlas/observations.json`.
 *
 * @example
 * // DirectXMath has JPL's product and is not JPL: it rotates by R(q).
 * const { handedness, rotate } = libraries.find(({ id }) => id === "directxmath");
 * handedness; // "left"
 * rotate; // "R"
 */
export const libraries: readonly Library[] = /* @__PURE__ */ deeplyFrozen(table as Library[]);

/** The value, in which nothing can be changed: one record serves all who ask for it. */
function deeplyFrozen<Value>(value: Value): Value {
  if (typeof value === "object" && value !== null) Object.values(value).forEach(deeplyFrozen);
  return Object.freeze(value);
}
