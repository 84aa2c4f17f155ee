// When a new version is said to be ready: a registration is simulated, so that what an engine tells of
// it, and when, is in the hands of the test.
import type { Page } from "@playwright/test";
import { expect, matrix, test } from "./support/page.ts";

/** In the page, before its own scripts. */
function simulate() {
  class Worker extends EventTarget {
    state = "installing";
  }
  const registration = Object.assign(new EventTarget(), {
    installing: null as Worker | null,
    waiting: null as Worker | null,
    active: null as Worker | null,
  });
  const workers = Object.assign(new EventTarget(), {
    controller: null as Worker | null,
    register: async () => {
      Object.assign(globalThis, { isRegistered: true });
      return registration;
    },
  });
  Object.defineProperty(navigator, "serviceWorker", { value: workers });
  const become = (worker: Worker, state: string) => {
    worker.state = state;
    worker.dispatchEvent(new Event("statechange"));
  };
  const find = () => {
    const worker = new Worker();
    registration.installing = worker;
    registration.dispatchEvent(new Event("updatefound"));
    registration.installing = null;
    registration.waiting = worker;
    return worker;
  };
  Object.assign(globalThis, { simulation: { registration, workers, become, find } });
}

/** What `simulate` leaves in the page. */
declare const simulation: {
  registration: { waiting: object | null; active: object | null };
  workers: { controller: object | null };
  become: (worker: object, state: string) => void;
  find: () => object;
};

const line = (page: Page) => page.getByText("A new version is ready.");

async function open(page: Page) {
  await page.addInitScript(simulate);
  await page.goto("/");
  await expect(matrix(page, "R(q)")).toBeVisible();
  await page.waitForFunction(() => "isRegistered" in globalThis);
}

test("a first version that takes over is not a new one, in whatever order that is told", async ({
  page,
}) => {
  await open(page);
  await page.evaluate(() => {
    const { registration, workers, become, find } = simulation;
    const first = find();
    // WebKit: in control before it is told that it was installed, and no more waiting after that.
    workers.controller = first;
    become(first, "installed");
    registration.active = first;
    become(first, "activating");
    become(first, "activated");
    registration.waiting = null;
  });
  // After the frame in which it would be said.
  await page.evaluate(() => new Promise((painted) => requestAnimationFrame(painted)));
  await expect(line(page)).toHaveCount(0);
  // The next one is new, also in the tab of the first visit.
  await page.evaluate(() => simulation.become(simulation.find(), "installed"));
  await expect(line(page)).toBeVisible();
});

test("a version that waits already is said to be ready", async ({ page }) => {
  await page.addInitScript(simulate);
  await page.addInitScript(() => {
    const { registration, workers, become, find } = simulation;
    workers.controller = registration.active = new EventTarget();
    become(find(), "installed");
  });
  await page.goto("/");
  await expect(line(page)).toBeVisible();
});
