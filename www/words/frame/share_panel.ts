// The words of the panel that shares a page.
export const panelWords = {
  panel: "Share what the page shows",
  link: "Link",
  markdown: "Link as Markdown",
  citation: "Cite this case",
  copy: (what: string) => `Copy: ${what}`,
  copied: (what: string) => `${what}: copied`,
  notAllowed: (what: string) => `${what}: not copied, the browser does not allow it`,
  noCase: "There is nothing to cite while the text has a problem.",
};
