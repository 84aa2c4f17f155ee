// Keeps the page for use without a network, and says when a new version is ready. Nothing is
// reloaded unasked.
import { type ComponentChildren, render } from "preact";
import "./view/offline.css";
import { newVersion } from "./words/offline.ts";

export async function keepOffline() {
  // Absent without a secure connection; registering fails where the visitor forbids storage.
  const workers = navigator.serviceWorker;
  const registration = await workers
    ?.register("./service_worker.js", { updateViaCache: "none" })
    .catch(() => undefined);
  if (!registration) return;
  // A first version takes over at once. That it waits for a moment is seen by some browsers only when
  // it is in control already: so what counts is what was there when it was found.
  const look = () => {
    if (!registration.active || registration.active === registration.waiting) return;
    const sayIfWaiting = () =>
      registration.waiting?.state === "installed" && sayReady(registration);
    registration.installing?.addEventListener("statechange", sayIfWaiting);
    sayIfWaiting();
  };
  registration.addEventListener("updatefound", look);
  look();
}

const lineId = "new-version";

function sayReady(registration: ServiceWorkerRegistration) {
  if (document.getElementById(lineId)) return;
  const line = document.createElement("div");
  line.id = lineId;
  line.role = "status";
  document.body.append(line);
  const say = (rest: ComponentChildren) =>
    render(
      <p class="new-version">
        {newVersion.ready} {rest}
      </p>,
      line,
    );
  const reload = () => {
    // Another tab may have let the new version take over already.
    if (!registration.waiting) return location.reload();
    say(newVersion.reloading);
    navigator.serviceWorker.addEventListener("controllerchange", () => location.reload());
    registration.waiting.postMessage("take over");
  };
  // What a status holds is read aloud when it changes, not when it appears.
  requestAnimationFrame(() =>
    say(
      <>
        <button type="button" onClick={reload}>
          {newVersion.reload}
        </button>
        <button type="button" onClick={() => line.remove()}>
          {newVersion.later}
        </button>
      </>,
    ),
  );
}
