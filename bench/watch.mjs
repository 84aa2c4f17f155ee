/**
 * To be run in the page before all else; what it sees is `globalThis.seen`, at last. It looks after each
 * frame, when that is painted. As soon as there is a field, a text is typed into it, once: where the page
 * loses it, it is typed again, and that is counted.
 * - `paintMs`: the first paint with content; `matrixMs`: that of the first matrix, whole and visible.
 * - `liveMs`: that of the matrix of what was typed. `heardMs`: the same where the text had to wait for the
 *   page; where it was answered at once, when it was typed.
 * - `shift`: what moved by itself, where the engine tells it.
 */
export function watch({ typed, longestMs }) {
  const seen = { lost: 0 };
  const observe = (type, note) => {
    const observer = new PerformanceObserver((list) => list.getEntries().forEach(note));
    observer.observe({ type, buffered: true });
  };
  observe("paint", ({ name, startTime }) => {
    if (name === "first-contentful-paint") seen.paintMs = startTime;
  });
  if (PerformanceObserver.supportedEntryTypes.includes("layout-shift")) {
    seen.shift = 0;
    observe("layout-shift", ({ value, hadRecentInput }) => {
      if (!hadRecentInput) seen.shift += value;
    });
  }

  /** The numbers of the first matrix as they can be read; nothing where they cannot. */
  const matrix = () => {
    const cells = [...document.querySelectorAll(".result td")].slice(0, 9);
    const places = cells.map((cell) => cell.querySelector("input") ?? cell);
    const isSeen = (place) =>
      place.checkVisibility({ visibilityProperty: true, opacityProperty: true });
    const texts = places.map((place) =>
      (place.value ?? place.textContent).replace("−", "-").trim(),
    );
    const isWhole = texts.length === 9 && texts.every((text) => /\d/.test(text));
    return isWhole && places.every(isSeen) ? texts.map(Number) : undefined;
  };
  const isAnswered = (numbers) =>
    numbers?.every((number, at) => Math.abs(number - typed.numbers[at]) < 1e-4) ?? false;

  let isTyped = false;
  const type = (field) => {
    if (isTyped) seen.lost += 1;
    isTyped = true;
    const nowMs = performance.now();
    field.value = typed.text;
    field.dispatchEvent(new InputEvent("input", { bubbles: true, inputType: "insertText" }));
    // The page writes its answer in a microtask that waits already.
    queueMicrotask(() => {
      if (isAnswered(matrix())) seen.heardMs = nowMs;
    });
  };
  const look = () => {
    const nowMs = performance.now();
    const numbers = matrix();
    if (numbers !== undefined) seen.matrixMs ??= nowMs;
    if (isAnswered(numbers)) {
      seen.liveMs ??= nowMs;
      seen.heardMs ??= nowMs;
      return;
    }
    const field = document.querySelector(".ask textarea:read-write");
    if (field !== null && field.value !== typed.text) type(field);
  };
  // A message that a frame sends arrives when the frame is painted.
  const { port1: painted, port2: frame } = new MessageChannel();
  globalThis.seen = new Promise((settle) => {
    setTimeout(() => settle(seen), longestMs);
    painted.onmessage = () => {
      look();
      // The first paint is told a little later, and nothing is seen before it.
      if (seen.liveMs === undefined || seen.paintMs === undefined) return;
      seen.matrixMs = Math.max(seen.matrixMs, seen.paintMs);
      settle(seen);
    };
  });
  const eachFrame = () => {
    frame.postMessage("");
    if (seen.liveMs === undefined || seen.paintMs === undefined) requestAnimationFrame(eachFrame);
  };
  requestAnimationFrame(eachFrame);
}
