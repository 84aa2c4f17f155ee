// Stands in the head of the page, and runs before its first paint and before any other script: what is asked
// for first; the theme chosen by hand, of which state/settings.ts does the rest; whether the example in the
// page is what the address shows; and what is said where no other script arrives that could say so.
{
  const { dataset } = document.documentElement;
  const [visit] = performance.getEntriesByType("navigation");
  const cameMs = visit && performance.now() - visit.requestStart;

  /** The view of the address, where it is not Read. */
  const otherView = () =>
    /^#(compose|motion|frames|translate|identify|libraries)(?![^?])/.exec(location.hash)?.[1];

  // The core is on its way before the program is, which takes the answer (engine.ts). A browser would
  // preload it too, and some then load it again.
  const core = [undefined, "compose"].includes(otherView()) ? "small" : "whole";
  const link = document.querySelector(`link[data-core=${core}]`);
  if (link !== null) {
    const answer = fetch(link.href);
    // The program says why it does not come.
    answer.catch(() => {});
    globalThis.askedFirst = { url: link.href, answer };
  }

  /** Nothing where storage is refused. */
  const stored = (storage, key) => {
    try {
      return globalThis[storage].getItem(key);
    } catch {
      return null;
    }
  };
  const remembered = (setting) => stored("localStorage", `quatlas-${setting}`);

  const theme = remembered("theme");
  if (theme === "light" || theme === "dark") dataset.theme = theme;

  // Of the line that is copied as code there is nothing yet.
  const format = stored("localStorage", "quatlas.copy-format");
  if (format !== null && format !== "numbers") dataset.format = "";

  /** Whether what was typed just before a reload, or before leaving, comes back. */
  const comesBack = () =>
    visit !== undefined &&
    visit.type !== "navigate" &&
    !/^$|"fragment":"read"}$/.test(stored("sessionStorage", "quatlas closing") ?? "");

  /** Whether the numbers in the page are those that the program will show. */
  const showsExample = () => {
    if (comesBack()) return false;
    if (location.hash !== "") return location.hash === "#read";
    return (
      [null, "6"].includes(remembered("digits")) && [null, "degrees"].includes(remembered("unit"))
    );
  };

  /** Until the program is there, the frame of another case is empty. */
  const showFrame = () => {
    if (showsExample()) delete dataset.case;
    else dataset.case = otherView() ?? "read";
  };
  showFrame();

  // The letters weigh as much as the program, and so they come later (dom/letters.ts) but where they hold
  // nothing up: where this browser has them, or where the page itself came at once. Then they are there with
  // the first paint, or not in this visit, so that nothing moves.
  const atOnceMs = 100;
  const areKept = remembered("letters") === "kept";
  const letters = document.querySelector("style[data-letters]");
  if (letters !== null && (areKept || cameMs < atOnceMs)) {
    letters.media = "all";
    dataset.letters = "coming";
    const show = (media) => {
      if (dataset.letters === undefined) return;
      letters.media = media;
      delete dataset.letters;
    };
    const faces = [...document.fonts].map((face) => face.load());
    Promise.all(faces).then(
      () => show("all"),
      () => show("not all"),
    );
    // What is kept comes.
    setTimeout(() => show("not all"), areKept ? 1000 : atOnceMs);
  }

  const isStarted = () => document.querySelector("[data-starting]") === null;
  const untilStarted = (type, does) =>
    addEventListener(type, (event) => isStarted() || does(event), { capture: true });

  untilStarted("hashchange", showFrame);

  // What is done with the page meanwhile is done again, in its order, when the program is there
  // (dom/meanwhile.ts). The numbers are not those of what was typed; a moment later they may be.
  const deeds = [];
  globalThis.doneFirst = deeds;
  const momentMs = 200;
  const note = (deed) => {
    const last = deeds.at(-1);
    const goesOn = last?.control === deed.control && "value" in deed;
    if (goesOn) last.value = deed.value;
    else deeds.push(deed);
    setTimeout(() => {
      if (!isStarted()) dataset.waiting = "";
    }, momentMs);
  };
  untilStarted("input", ({ target }) => note({ control: target, value: target.value }));
  untilStarted("click", (event) => {
    const control = event.target.closest("#page :is(button, a[href^='#'])");
    if (control === null) return;
    if (control.matches("a")) {
      // A browser follows it by itself, and would leave behind what was typed.
      if (deeds.length === 0 || event.ctrlKey || event.metaKey || event.shiftKey) return;
      event.preventDefault();
    }
    note({ control });
  });
  untilStarted("compositionstart", () => {
    dataset.composing = "";
  });
  untilStarted("compositionend", () => delete dataset.composing);

  /** Loads the page again, with what was typed. */
  const tryAgain = () => {
    const texts = [...document.querySelectorAll("#page textarea")];
    const typed = texts.filter(({ value, defaultValue }) => value !== defaultValue);
    const parameters = new URLSearchParams(typed.map(({ name, value }) => [name, value]));
    if (typed.length > 0) location.hash = `read?v=1&${parameters}`;
    location.reload();
  };
  untilStarted("click", ({ target }) => {
    if (target.matches("[data-not-started] button")) tryAgain();
  });

  const sayNotStarted = () => {
    if (isStarted()) return;
    document.querySelector("[data-loading]").hidden = true;
    document.querySelector("[data-not-started]").hidden = false;
  };
  addEventListener(
    "error",
    ({ target }) => {
      // Without a style or an icon the page works. The window is the target of what a script throws.
      if (target instanceof HTMLLinkElement) return;
      if (document.readyState !== "loading") sayNotStarted();
      else addEventListener("DOMContentLoaded", sayNotStarted);
    },
    { capture: true },
  );
}
