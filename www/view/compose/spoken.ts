// What a screen reader hears when the product changes.
import { shown } from "../../number/format.ts";
import type { Store } from "../../state/store.ts";
import * as words from "../../words/compose/compose.tsx";
import { nameOf } from "../parts/convention_names.ts";
import { namesInOrder } from "../parts/Value.tsx";

export function spokenProduct(store: Store): string {
  const product = store.compose.value?.report.declared;
  if (product === undefined) return "";
  const { convention, quaternion } = product;
  const { digits } = store.state.value;
  const numbers = namesInOrder(convention).map(
    (name) => `${name} ${shown(quaternion[name], digits)}`,
  );
  return words.spokenProduct(nameOf(convention, store.engine) ?? words.yours, numbers);
}
