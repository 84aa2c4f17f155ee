// The drawing as a file of its own: light colours, no style sheet, words inside.

/** The colours of picture.css on white paper. */
const inks: Record<string, string> = {
  "--axis-x": "#b3261e",
  "--axis-y": "#1c7a35",
  "--axis-z": "#1f5fc4",
  "--side": "#f3f2ee",
  "--side-x": "#fae9e6",
  "--side-y": "#e6f4e8",
  "--side-z": "#e7effc",
  "--picture-ink": "#171a1f",
  "--picture-soft": "#7b818c",
  "--picture-edge": "#9aa0aa",
  "--picture-shade": "#000000",
  "--picture-accent": "#8a2fb8",
  "--picture-paper": "#ffffff",
};

const namespace = "http://www.w3.org/2000/svg";

/** The text of a self-contained SVG: what is drawn, with its title and what it shows in words. */
export function svgText(stage: SVGSVGElement, title: string, description: string): string {
  const copy = stage.cloneNode(true) as SVGSVGElement;
  for (const element of [copy, ...copy.querySelectorAll("*")]) {
    for (const { name, value } of [...element.attributes]) {
      const ink = value.match(/^var\((--[\w-]+)\)$/)?.[1];
      if (ink) element.setAttribute(name, inks[ink] ?? "#000");
      if (/^(?:class|role|tabindex|aria-.*|pointer-events)$/.test(name)) {
        element.removeAttribute(name);
      }
    }
  }
  copy.setAttribute("xmlns", namespace);
  const [, , width = "", height = ""] = (copy.getAttribute("viewBox") ?? "").split(" ");
  copy.setAttribute("width", width);
  copy.setAttribute("height", height);
  copy.prepend(words("title", title), words("desc", description));
  return `${new XMLSerializer().serializeToString(copy)}\n`;
}

function words(name: "title" | "desc", text: string): Element {
  const element = document.createElementNS(namespace, name);
  element.textContent = text;
  return element;
}

/** Hands a text to the browser as a file. */
export function saveFile(name: string, text: string) {
  const address = URL.createObjectURL(new Blob([text], { type: "image/svg+xml" }));
  const link = document.createElement("a");
  link.href = address;
  link.download = name;
  link.click();
  // The browser has begun to read it by the next turn of the event loop.
  setTimeout(() => URL.revokeObjectURL(address), 0);
}
