// The words of a part that comes after the first result.

export const waits = {
  loading: "Loading …",
  failed: "This part could not be loaded. Reload the page to try again.",
};
