// One motion from start to end, once, and none for those who asked for less of it.
import { useEffect, useRef, useState } from "preact/hooks";

const durationMs = 900;
const eased = (part: number) => part * part * (3 - 2 * part);
export const motionIsReduced = () => matchMedia("(prefers-reduced-motion: reduce)").matches;

/** From 0 to 1 after each start; 1 where nothing moves. */
export function useMotion(): { progress: number; start: (atEnd?: () => void) => void } {
  const [progress, setProgress] = useState(1);
  const frame = useRef(0);
  useEffect(() => () => cancelAnimationFrame(frame.current), []);
  const start = (atEnd?: () => void) => {
    cancelAnimationFrame(frame.current);
    if (motionIsReduced()) {
      setProgress(1);
      atEnd?.();
      return;
    }
    let began: number | undefined;
    const step = (now: number) => {
      began ??= now;
      const part = Math.min(1, (now - began) / durationMs);
      setProgress(eased(part));
      if (part < 1) frame.current = requestAnimationFrame(step);
      else atEnd?.();
    };
    setProgress(0);
    frame.current = requestAnimationFrame(step);
  };
  return { progress, start };
}
