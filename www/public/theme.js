// The theme chosen by hand, before the first paint; settings.ts does the rest.
try {
  const theme = localStorage.getItem("quatlas-theme");
  if (theme === "light" || theme === "dark") document.documentElement.dataset.theme = theme;
} catch {
  // No storage: the theme of the system.
}
