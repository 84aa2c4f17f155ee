// The browsers that the page is tested in: found on this machine, or installed where that can be done.
import { existsSync } from "node:fs";
import { ask, runQuietly, Stop, say } from "./shell.mjs";

/** Each with the variable that tells the tests its path, and the packages of Debian and Ubuntu. */
const CHROMIUM = {
  name: "Chromium",
  variable: "QUATLAS_BROWSER",
  programs: [["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"]],
  paths: [
    "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
    "C:\\Program Files\\Google\\Chrome\\Application\\chrome.exe",
  ],
  packages: ["chromium", "fonts-dejavu-core"],
};
const FIREFOX = {
  name: "Firefox",
  variable: "QUATLAS_FIREFOX",
  programs: [["firefox-esr", "firefox"]],
  paths: [
    "/Applications/Firefox.app/Contents/MacOS/firefox",
    "C:\\Program Files\\Mozilla Firefox\\firefox.exe",
  ],
  packages: ["firefox-esr", "fonts-dejavu-core"],
};
/** Its driver starts it, on the screen of Xvfb. */
const WEBKIT = {
  name: "WebKit",
  variable: "QUATLAS_WEBKIT",
  programs: [["WebKitWebDriver"], ["Xvfb"]],
  paths: [],
  packages: ["webkit2gtk-driver", "xvfb", "fonts-dejavu-core"],
};

/**
 * The names of the engines that the tests can run in, with their paths in the environment. One that
 * cannot be had is left out, unless QUATLAS_ENGINES is "all"; Chromium never is.
 */
export async function setUpEngines() {
  process.env[CHROMIUM.variable] = (await setUpChromium()) ?? "";
  const covered = [CHROMIUM.name];
  for (const engine of [FIREFOX, WEBKIT]) {
    const path = await findOrInstall(engine);
    process.env[engine.variable] = path ?? "";
    if (path === undefined) leaveOut(engine);
    else covered.push(engine.name);
  }
  return covered;
}

/** Finds or installs a Chromium and returns its path; undefined where Playwright has its own. */
export async function setUpChromium() {
  const path = await findOrInstall(CHROMIUM);
  if (path !== undefined) return path;
  say("installing Playwright's Chromium for the browser tests (first time only, a minute)");
  const advice = "install Chromium or Chrome by hand and run this again";
  const install = { task: "install Playwright's Chromium", advice };
  await runQuietly(install, "playwright", "install", "chromium");
  return undefined;
}

function leaveOut({ name }) {
  const reason = `there is no ${name} for the browser tests, and none could be installed`;
  if (process.env.QUATLAS_ENGINES === "all") {
    throw new Stop(`${reason}: install it by hand, or run this without QUATLAS_ENGINES=all`);
  }
  say(`${reason}: it is left out`);
}

const findOrInstall = async (engine) => find(engine) ?? (await installPackages(engine));

/** The path of an engine's first program, where all of them are there. */
function find({ programs, paths }) {
  const path = paths.find(existsSync);
  if (path !== undefined || process.platform === "win32") return path;
  const found = programs.map((names) => names.map((name) => ask("which", name)).find(Boolean));
  return found.every(Boolean) ? found[0] : undefined;
}

async function installPackages(engine) {
  const isRoot = process.getuid?.() === 0;
  if (!isRoot || ask("apt-get", "--version") === undefined) return undefined;
  const { name, packages } = engine;
  say(`installing the distribution's ${name} for the browser tests (first time only, a minute)`);
  try {
    const install = { task: `install ${name}`, advice: "check the network connection" };
    const options = ["-y", "--no-install-recommends"];
    await runQuietly(install, "apt-get", "update");
    await runQuietly(install, "apt-get", "install", ...options, ...packages);
  } catch (error) {
    if (!(error instanceof Stop)) throw error;
  }
  return find(engine);
}
