// The service worker, which keeps the page for use without a network.

/** Registers the worker, and calls back for each new version that is ready and waits. */
export async function keepPage(onReady: (registration: ServiceWorkerRegistration) => void) {
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
    const sayIfWaiting = () => registration.waiting?.state === "installed" && onReady(registration);
    registration.installing?.addEventListener("statechange", sayIfWaiting);
    sayIfWaiting();
  };
  registration.addEventListener("updatefound", look);
  look();
}

/** Lets the version that waits take over, and loads the page anew by it. */
export function takeOver(waiting: ServiceWorker) {
  navigator.serviceWorker.addEventListener("controllerchange", () => location.reload());
  waiting.postMessage("take over");
}
