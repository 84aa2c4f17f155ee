// A view that is loaded when it is opened.
import { useEffect } from "preact/hooks";
import type { Store } from "../../state/store.ts";
import { loadingLine, notLoadedLine, retryWord } from "../../words/frame/loading.tsx";
import { type LazyView, load, loadingOf } from "./lazy_views.ts";
import "./loading.css";

export function Lazy({ view, name, store }: { view: LazyView; name: string; store: Store }) {
  const loading = loadingOf[view].value;
  useEffect(() => {
    load(view, store);
  }, [view, store]);
  switch (loading.status) {
    case "loaded":
      return <loading.Shown store={store} />;
    case "failed":
      return (
        <p class="loading" role="alert">
          {notLoadedLine(name)}{" "}
          <button type="button" class="quiet" onClick={() => load(view, store)}>
            {retryWord}
          </button>
          <small>{loading.reason}</small>
        </p>
      );
    default:
      return <p class="loading">{loadingLine(name)}</p>;
  }
}
