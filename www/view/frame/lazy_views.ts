// The views that are not in the first load. Each is a file of its own, and most ask the whole core.
import { type Signal, signal } from "@preact/signals";
import type { VNode } from "preact";
import { loadWhole } from "../../action/whole_core.ts";
import { type Engine, loadSmallEngine } from "../../engine.ts";
import { smallViews, type View } from "../../model/page_state.ts";
import { type Asks, asksOf, type Store } from "../../state/store.ts";

export interface LoadedView {
  Shown: (props: { store: Store }) => VNode;
  /** What a screen reader hears when the result changes. */
  spoken: (store: Store) => string;
  /** What it asks the core, where that is not asked at the start. */
  asks?: Asks;
}

const files = {
  compose: async () => {
    const { Compose, spokenProduct } = await import("../compose/Compose.tsx");
    return { Shown: Compose, spoken: spokenProduct };
  },
  motion: async () => {
    const { Motion, spokenMotion, askedOfMotion } = await import("../motion/Motion.tsx");
    return { Shown: Motion, spoken: spokenMotion, asks: askedOfMotion };
  },
  frames: async () => {
    const { Frames, spokenPose, askedOfFrames } = await import("../frames/Frames.tsx");
    return { Shown: Frames, spoken: spokenPose, asks: askedOfFrames };
  },
  translate: async () => {
    const { Translate, spokenTranslation, askedOfTranslate } = await import(
      "../translate/Translate.tsx"
    );
    return { Shown: Translate, spoken: spokenTranslation, asks: askedOfTranslate };
  },
  identify: async () => {
    const { Identify, spokenIdentity, askedOfIdentify } = await import("../identify/Identify.tsx");
    return { Shown: Identify, spoken: spokenIdentity, asks: askedOfIdentify };
  },
  libraries: async () => {
    const { Libraries, spokenLibraries } = await import("../libraries/Libraries.tsx");
    return { Shown: Libraries, spoken: spokenLibraries };
  },
} satisfies Partial<Record<View, () => Promise<LoadedView>>>;
export type LazyView = keyof typeof files;

export type Loading =
  | { status: "asleep" | "loading" }
  | { status: "failed"; reason: string }
  | ({ status: "loaded" } & LoadedView);

/** How far each view is. */
export const loadingOf: Record<LazyView, Signal<Loading>> = {
  compose: signal({ status: "asleep" }),
  motion: signal({ status: "asleep" }),
  frames: signal({ status: "asleep" }),
  translate: signal({ status: "asleep" }),
  identify: signal({ status: "asleep" }),
  libraries: signal({ status: "asleep" }),
};

export function isLazy(view: View): view is LazyView {
  return view in files;
}

/** Whether a view asks what the core of the first load does not answer. */
function needsWholeCore(view: View): boolean {
  return !smallViews.includes(view);
}

/** The core that a view begins with. Its file comes beside it, so that it stands there with the first result. */
export async function beginWith(view: View): Promise<Engine> {
  const [engine] = await Promise.all([
    needsWholeCore(view) ? loadWhole() : loadSmallEngine(),
    isLazy(view) ? loadFile(view) : undefined,
  ]);
  return engine;
}

/** Loads the file of a view whose core is there. It never throws: where it fails the view tries again. */
export async function loadFile(view: LazyView) {
  const loading = loadingOf[view];
  if (loading.peek().status === "loaded") return;
  try {
    loading.value = asking(view, await files[view]());
  } catch {}
}

/** Loads a view and the core that it needs, unless that is done or under way. It never throws. */
export async function load(view: LazyView, store: Store) {
  const loading = loadingOf[view];
  const { status } = loading.peek();
  if (status === "loading" || status === "loaded") return;
  loading.value = { status: "loading" };
  try {
    const [loaded, engine] = await Promise.all([
      files[view](),
      needsWholeCore(view) ? loadWhole() : undefined,
    ]);
    // First the core: what is shown of the view already has its answers.
    if (engine) store.useEngine(engine);
    loading.value = asking(view, loaded);
  } catch (error) {
    loading.value = { status: "failed", reason: String(error) };
  }
}

/** The loaded view, whose questions are asked from now on. */
function asking(view: LazyView, loaded: LoadedView): Loading {
  if (loaded.asks) asksOf.value = { ...asksOf.peek(), [view]: loaded.asks };
  return { status: "loaded", ...loaded };
}
