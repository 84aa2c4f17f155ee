// Whether every number of the page can be read whole, as the engine itself measures it.

/** Every view, with the opening's numbers, with long and small ones, and with all their digits. */
const longest = "quaternion=-0.1111111111111119 -1.2345678901234567e-300 0.38 -0.92";
export const addresses = [
  "read?digits=4",
  "read",
  "read?quaternion=-0.1234 -0.2345 -0.3456 -0.8",
  "read?digits=all",
  `read?unit=rad&euler=zxz&${longest}`,
  `read?digits=all&${longest}`,
  "compose?p=-0.1 0.2 0.3 -0.4&q=1e-9 -0.3 0.123 0.9",
  "compose?digits=all",
  `read?digits=all&open=atlas,swing-twist&${longest}`,
  "compose?digits=all&open=between,chain&p=-0.1 0.2 0.3 -0.4",
  "motion?digits=all&unit=rad&open=covariance,point",
  "frames?digits=all",
  "translate?worldAxes=NED to ENU",
  "translate?digits=all&translated=-0.1 0.2 -0.3 -0.4",
  "identify?digits=all",
  "libraries?library=eigen",
];

type Extent = Pick<DOMRect, "left" | "right">;

/** Whether the view is there. To be run in the page. */
export const isShown = () =>
  document.querySelector("main table, main .answer") !== null &&
  document.querySelector("main .loading, [data-loading], .picture-wait, .fold-wait") === null;

/**
 * The numbers of the page that are cut, broken over lines or out of their box, each with its fault;
 * and whether the page itself is wider than the window. Only a matrix may scroll as a whole, and shows
 * that it does. To be run in the page, with everything in it opened: so it stands by itself.
 */
export async function cutNumbers(): Promise<string[]> {
  for (const details of document.querySelectorAll("details")) details.open = true;
  // Where there is room for one column, both, as if the visitor switched.
  for (const columns of document.querySelectorAll(".columns")) {
    columns.classList.remove("columns-of-hamilton", "columns-of-jpl");
  }
  // The signs at the edges follow the sizes by a frame or two.
  for (const _ of [1, 2, 3, 4]) await new Promise((painted) => requestAnimationFrame(painted));
  const faults: string[] = [];
  /** Of a place on the screen, which engines round. */
  const roundingPx = 0.5;
  const windowWidth = document.documentElement.clientWidth;
  const namedBy = (node: Element) =>
    node.closest("[aria-label]")?.getAttribute("aria-label") ?? node.className;

  /** The box of the page that ends before a number does. */
  const cutBy = (node: Element, { left, right }: Extent): string | undefined => {
    const isOutOf = (from: number, to: number) =>
      left < from - roundingPx || right > to + roundingPx;
    for (let box = node.parentElement; box !== null; box = box.parentElement) {
      // The settings are one row, which goes on sideways on a phone.
      if (box.matches(".matrix-scroll, .ask-line")) return undefined;
      const { overflowX, display } = getComputedStyle(box);
      if (overflowX === "visible" || display === "inline") continue;
      const { left: from, right: to } = box.getBoundingClientRect();
      if (isOutOf(from, to)) return `is cut by ${box.className || box.tagName}`;
    }
    return isOutOf(0, windowWidth) ? "is outside of the window" : undefined;
  };

  const ruler = document.createElement("span");
  Object.assign(ruler.style, { position: "absolute", whiteSpace: "pre", visibility: "hidden" });
  document.body.append(ruler);
  for (const field of document.querySelectorAll<HTMLInputElement>("input[type=text]")) {
    if (!/\d/.test(field.value)) continue;
    const style = getComputedStyle(field);
    const { fontFamily, fontSize, fontWeight, letterSpacing, fontFeatureSettings } = style;
    const font = { fontFamily, fontSize, fontWeight, letterSpacing, fontFeatureSettings };
    Object.assign(ruler.style, font);
    ruler.textContent = field.value;
    const around = [style.paddingLeft, style.paddingRight].map(Number.parseFloat);
    const box = field.getBoundingClientRect();
    const room = box.width - around.reduce((sum, padding) => sum + padding, 0);
    const missing = ruler.getBoundingClientRect().width - room;
    // An engine may add a part of a pixel that is too small to be seen, and cuts a digit for it.
    if (missing > 0 || field.scrollWidth > field.clientWidth) {
      faults.push(`${namedBy(field)}: "${field.value}" lacks ${missing.toFixed(3)} px`);
    }
    const cut = cutBy(field, box);
    if (cut) faults.push(`${namedBy(field)}: "${field.value}" ${cut}`);
  }
  ruler.remove();

  const number = /(?<![\d.\w])[−-]?\d(?:[\d.]*\d)?(?:e[−-]?\d+)?/g;
  // A line of code that is copied is shown as far as there is room: its numbers stand above it.
  const unread =
    "textarea, select, noscript, .field-mirror, .visually-hidden, .skip, .copy-line > code";
  const range = document.createRange();
  const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  for (let text = texts.nextNode(); text !== null; text = texts.nextNode()) {
    const parent = text.parentElement;
    const content = text.textContent ?? "";
    if (parent === null || !/\d/.test(content) || parent.closest(unread)) continue;
    if (!parent.checkVisibility()) continue;
    let own: Element = parent;
    while (getComputedStyle(own).display === "inline" && !own.closest("svg")) {
      own = own.parentElement as Element;
    }
    // What is clipped away is there to be read aloud.
    if (getComputedStyle(own).clipPath !== "none") continue;
    const box = (own.closest("svg") ?? own).getBoundingClientRect();
    for (const { 0: digits, index } of content.matchAll(number)) {
      range.setStart(text, index);
      range.setEnd(text, index + digits.length);
      // WebKit also tells the end of the line before a number, which has no width.
      const parts = [...range.getClientRects()].filter(({ width }) => width > 0);
      const lines = new Set(parts.map(({ top }) => Math.round(top)));
      if (lines.size > 1) faults.push(`${namedBy(parent)}: ${digits} is broken over lines`);
      const left = Math.min(...parts.map((part) => part.left));
      const place: Extent = { left, right: Math.max(...parts.map((part) => part.right)) };
      if (place.left < box.left - roundingPx || place.right > box.right + roundingPx) {
        faults.push(`${namedBy(parent)}: ${digits} stands out of its box`);
      }
      const cut = cutBy(parent, place);
      if (cut) faults.push(`${namedBy(parent)}: ${digits} ${cut}`);
    }
  }

  for (const matrix of document.querySelectorAll<HTMLElement>(".matrix-scroll")) {
    const isWide = matrix.scrollWidth > matrix.clientWidth + 1;
    const sign = getComputedStyle(matrix.parentElement as Element, "::after");
    const isSaid = sign.borderTopWidth !== "0px" && sign.content !== "none";
    if (isWide !== isSaid) faults.push(`${namedBy(matrix)}: goes on ${isWide}, says so ${isSaid}`);
  }
  // Three usual numbers in one bracket stand in one line, or each in its own.
  for (const vector of windowWidth > 1200 ? document.querySelectorAll(".vector") : []) {
    const isUsual = [...vector.querySelectorAll("input")].every(({ value }) => value.length < 10);
    const lines = [...vector.children].map((box) => box.getBoundingClientRect().top);
    if (isUsual && ![1, lines.length].includes(new Set(lines).size)) {
      faults.push(`${namedBy(vector)}: three numbers in two lines`);
    }
  }
  const beyond = document.documentElement.scrollWidth - windowWidth;
  if (beyond > 0) faults.push(`the page is ${beyond} px wider than the window`);
  return faults;
}
