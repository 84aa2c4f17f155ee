// The words of the page that is kept for use without a network.
export const newVersion = {
  ready: "A new version is ready.",
  reload: "Reload",
  reloading: "Reloading …",
  later: "Later",
};
