// The numbers of a matrix, which may be wider than their place: they scroll sideways as a whole, and
// signs at the edges say where they go on.
import type { ComponentChild } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";
import type { Digits } from "../../model/page_state.ts";
import "./side_scroll.css";

/** Of a scroll position, which engines round. */
const onePixel = 1;

export function SideScroll({
  name,
  digits,
  children,
}: {
  /** For screen readers. */
  name: string;
  digits: Digits;
  children: ComponentChild;
}) {
  const frame = useRef<HTMLElement>(null);
  const [hidden, setHidden] = useState("");
  const look = () => {
    if (frame.current) setHidden(hiddenSides(frame.current));
  };
  useEffect(() => {
    const node = frame.current;
    if (node === null) return;
    // It looks at once, and whenever the place or what stands in it has another size: in the next frame,
    // since what changes within this one an engine tells as an error.
    let nextFrame = 0;
    const observer = new ResizeObserver(() => {
      cancelAnimationFrame(nextFrame);
      nextFrame = requestAnimationFrame(look);
    });
    observer.observe(node);
    for (const child of node.children) observer.observe(child);
    return () => {
      observer.disconnect();
      cancelAnimationFrame(nextFrame);
    };
  }, []);
  const isReached = hidden === "" || frame.current?.querySelector("input") !== null;
  return (
    <div class="side-scroll" data-hidden={hidden}>
      <section
        ref={frame}
        class={`matrix-scroll digits-${digits}`}
        aria-label={name}
        onScroll={look}
        // Where it scrolls the arrow keys reach all of it, from field to field if it has some.
        {...(isReached ? {} : { tabIndex: 0 })}
      >
        {children}
      </section>
    </div>
  );
}

/** The sides behind which it goes on. */
function hiddenSides({ scrollLeft, scrollWidth, clientWidth }: HTMLElement): string {
  const isLeft = scrollLeft > onePixel;
  const isRight = scrollLeft + clientWidth < scrollWidth - onePixel;
  return [isLeft && "left", isRight && "right"].filter(Boolean).join(" ");
}
