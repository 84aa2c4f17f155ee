// One short line at the foot of the window, seen and heard: what was just copied.
import "./say.css";

const shownForMs = 2400;

const line = document.createElement("p");
line.className = "said";
line.setAttribute("aria-live", "polite");
// A live region must be there before its text is.
document.body.append(line);
let hiding: ReturnType<typeof setTimeout> | undefined;

export function say(text: string) {
  clearTimeout(hiding);
  line.textContent = text;
  hiding = setTimeout(() => {
    line.textContent = "";
  }, shownForMs);
}
