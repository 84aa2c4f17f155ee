// Where a panel stands beside the button that opens it: always whole inside the window.

const edge = 8;
const gap = 4;

/** Below the button with the right edges in line, above it where there is more room. */
export function placeBeside(panel: HTMLElement, anchor: Element) {
  const { clientWidth, clientHeight } = document.documentElement;
  const button = anchor.getBoundingClientRect();
  const below = clientHeight - button.bottom - gap - edge;
  const above = button.top - gap - edge;
  const isBelow = panel.scrollHeight <= below || below >= above;
  panel.style.maxHeight = `${Math.max(isBelow ? below : above, 120)}px`;
  const { width, height } = panel.getBoundingClientRect();
  const left = Math.min(Math.max(button.right - width, edge), clientWidth - width - edge);
  const top = isBelow ? button.bottom + gap : button.top - gap - height;
  panel.style.left = `${Math.max(left, edge)}px`;
  panel.style.top = `${Math.min(Math.max(top, edge), Math.max(clientHeight - height - edge, edge))}px`;
}
