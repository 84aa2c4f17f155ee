// Stands in the head of the page, and runs before its first paint and before any other script: the theme
// chosen by hand, of which state/settings.ts does the rest; what is asked for first; whether the example in
// the page is what the address shows; and what is said where no other script arrives that could say so.
{
  const { dataset } = document.documentElement;

  /** Nothing where storage is refused. */
  const stored = (storage, key) => {
    try {
      return globalThis[storage].getItem(key);
    } catch {
      return null;
    }
  };

  const [visit] = performance.getEntriesByType("navigation");

  const theme = stored("localStorage", "quatlas-theme");
  if (theme === "light" || theme === "dark") dataset.theme = theme;

  /** Whether the numbers in the page are those that the program will show. */
  const showsExample = () => {
    // What was typed just before a reload comes back.
    const closing = stored("sessionStorage", "quatlas closing") ?? "";
    const isReturn = visit !== undefined && visit.type !== "navigate";
    if (isReturn && !/^$|"fragment":"read"}$/.test(closing)) return false;
    if (location.hash === "#read") return true;
    if (location.hash !== "") return false;
    const chosen = (setting, usual) =>
      [null, usual].includes(stored("localStorage", `quatlas-${setting}`));
    return chosen("digits", "6") && chosen("unit", "degrees");
  };

  /** Until the program is there, the frame of another case is empty. */
  const showFrame = () => {
    if (showsExample()) delete dataset.case;
    else
      dataset.case = /^#(compose|translate|identify|libraries)/.exec(location.hash)?.[1] ?? "read";
  };

  const isStarted = () => document.querySelector("[data-starting]") === null;

  showFrame();

  // The core is on its way before the program is, which takes the answer (engine.ts). A browser would
  // preload it too, and some then load it again.
  const core = ["translate", "identify", "libraries"].includes(dataset.case) ? "whole" : "small";
  const link = document.querySelector(`link[data-core=${core}]`);
  if (link !== null) {
    const answer = fetch(link.href);
    // The program says why it does not come.
    answer.catch(() => {});
    globalThis.askedFirst = { url: link.href, answer };
  }

  // The letters weigh as much as the program, and so they come later (dom/letters.ts) but where they hold
  // nothing up: where this browser has them, or where the page itself came at once. Then they are there with
  // the first paint, or not in this visit, so that nothing moves.
  const atOnceMs = 100;
  const isNear = visit !== undefined && performance.now() - visit.requestStart < atOnceMs;
  const areKept = stored("localStorage", "quatlas-letters") === "kept";
  const letters = document.querySelector("style[data-letters]");
  if (letters !== null && (isNear || areKept)) {
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

  addEventListener("hashchange", () => {
    if (!isStarted()) showFrame();
  });

  // The numbers are not those of what was typed, until the program is there.
  addEventListener(
    "input",
    () => {
      if (!isStarted()) dataset.waiting = "";
    },
    { capture: true },
  );

  // What is pressed is done when the program is there (dom/typed.ts).
  addEventListener(
    "click",
    ({ target }) => {
      if (!isStarted()) target.closest("button")?.setAttribute("data-pressed", "");
    },
    { capture: true },
  );

  const sayNotStarted = () => {
    if (isStarted()) return;
    document.querySelector("[data-loading]").hidden = true;
    const line = document.querySelector("[data-not-started]");
    line.hidden = false;
    line.querySelector("button").onclick = () => location.reload();
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
