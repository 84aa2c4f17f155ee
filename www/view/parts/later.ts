// A part of a view that is loaded after the first result.
import type { ComponentType } from "preact";
import { useEffect, useState } from "preact/hooks";

type Later<Props> = ComponentType<Props> | "loading" | "failed";

/** The component, once its file is there. */
export function useLater<Props>(load: () => Promise<ComponentType<Props>>): Later<Props> {
  // A function in a state of its own would be called.
  const [{ part }, set] = useState<{ part: Later<Props> }>({ part: "loading" });
  useEffect(() => {
    let isHere = true;
    load().then(
      (loaded) => isHere && set({ part: loaded }),
      () => isHere && set({ part: "failed" }),
    );
    return () => {
      isHere = false;
    };
  }, [load]);
  return part;
}
