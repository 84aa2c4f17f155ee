// Before the first paint, and before any other script: the theme chosen by hand, of which
// state/settings.ts does the rest; and what is said where no other script arrives that could say so.
try {
  const theme = localStorage.getItem("quatlas-theme");
  if (theme === "light" || theme === "dark") document.documentElement.dataset.theme = theme;
} catch {
  // No storage: the theme of the system.
}

function sayNotStarted() {
  const line = document.querySelector("[data-not-started]");
  // Once the page is mounted, both lines are gone.
  if (line === null) return;
  document.querySelector("[data-loading]").hidden = true;
  line.hidden = false;
  line.querySelector("button").onclick = () => location.reload();
}

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
