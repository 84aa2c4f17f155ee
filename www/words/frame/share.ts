// The words of sharing that stand on the page.

export const shareWords = {
  share: "Share",
  newer:
    "This link was made by a newer quatlas: what is understood of it here is shown, and the rest is as at the opening.",
  version: (version: string) => `quatlas ${version}`,
};
