// Keeps the page for use without a network, and says when a new version is ready. Nothing is
// reloaded unasked.
import { type ComponentChildren, render } from "preact";
import { keepPage, takeOver } from "../../dom/service_worker.ts";
import { newVersion } from "../../words/frame/offline.ts";
import "./offline.css";

export const keepOffline = () => keepPage(sayReady);

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
    takeOver(registration.waiting);
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
