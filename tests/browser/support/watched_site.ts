// The built page with one script before all others, which notes what goes wrong in any engine.
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { writeServiceWorker } from "../../../www/tasks/precache.ts";
import { openSite } from "./site.ts";

export async function openWatchedSite() {
  const site = await openSite();
  const put = (name: string, text: string) => writeFileSync(join(site.folder, name), text);
  put("watch.js", `(${watch})();`);
  // For an engine whose window is not narrow enough.
  put("frame.html", '<!doctype html><title>A frame</title><link rel="icon" href="data:,">');
  const page = readFileSync(join(site.folder, "index.html"), "utf8");
  put("index.html", page.replace("<script", '<script src="./watch.js"></script><script'));
  writeServiceWorker(site.folder);
  return site;
}

/** The tab remembers it through loads. */
function watch() {
  const note = (fault: string) => {
    const faults = JSON.parse(sessionStorage.getItem("faults") ?? "[]");
    sessionStorage.setItem("faults", JSON.stringify([...faults, fault]));
  };
  const { error } = console;
  console.error = (...values) => {
    note(`console: ${values.join(" ")}`);
    error(...values);
  };
  addEventListener("error", ({ message }) => note(`error: ${message}`));
  addEventListener("unhandledrejection", ({ reason }) => note(`rejection: ${reason}`));
  addEventListener("securitypolicyviolation", ({ violatedDirective, blockedURI }) =>
    note(`policy: ${violatedDirective} ${blockedURI}`),
  );
}

/** What went wrong since this was asked last. To be run in the page. */
export function takeFaults(): string[] {
  const faults = JSON.parse(sessionStorage.getItem("faults") ?? "[]");
  sessionStorage.removeItem("faults");
  return faults;
}
