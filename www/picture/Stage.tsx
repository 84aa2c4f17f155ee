// The drawing, and the hands on it: drag or arrow keys go round it, or turn the body.
import { useLayoutEffect, useRef, useState } from "preact/hooks";
import type { Look } from "../model/picture_state.ts";
import { pictureWords as words } from "../words/picture.ts";
import { cameraOf, orbited, type Paper, rollAsSeen, turnAsSeen, usualPaper } from "./camera.ts";
import { Drawing } from "./Drawing.tsx";
import type { Scene } from "./scene.ts";
import type { Quaternion } from "./space.ts";

/** Degrees for a drag by one pixel, and for one press of a key. */
const degreesPerPixel = 0.6;
const degreesPerPress = 5;

const arrows: Record<string, readonly [number, number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

const rolls: Record<string, number> = { PageUp: 1, PageDown: -1 };

/** A pointer that was pressed on the drawing. */
interface Held {
  id: number;
  across: number;
  down: number;
  turns: "view" | "body";
  hasMoved: boolean;
  /** From where the picture was looked at. */
  look: Look;
}

/**
 * One finger on the body turns it, also up and down, where it moves the page elsewhere. What the styles
 * say of touches does not hold for a part of a drawing in every browser. What a finger touched first
 * hears of it until it is lifted, also when a turn has taken it out of the drawing.
 */
function keepFinger(touched: SVGElement, isTurning: () => boolean) {
  touched.ontouchmove = (event) => {
    if (isTurning() && event.touches.length === 1) event.preventDefault();
  };
}

export function Stage({
  scene,
  look,
  label,
  describedBy,
  onLook,
  onTurn,
  onTurned,
  onCancelled,
}: {
  scene: Scene;
  look: Look;
  label: string;
  describedBy: string;
  onLook: (look: Look) => void;
  /** A turn of the body about axes that are fixed in the world; nothing where it cannot be turned. */
  onTurn?: ((turn: Quaternion, by: "drag" | "key") => void) | undefined;
  /** The hand let the body go. */
  onTurned?: () => void;
  /** The Escape key, or the browser, took back what the hand did with the body. */
  onCancelled?: () => void;
}) {
  const [paper, setPaper] = useState<Paper>(usualPaper);
  const camera = cameraOf(look, paper);
  const held = useRef<Held | undefined>(undefined);
  const stage = useRef<HTMLDivElement>(null);
  // The drawing has the size of its place, before it is painted for the first time.
  useLayoutEffect(() => {
    const place = stage.current;
    if (place === null) return;
    const measure = () => {
      const { clientWidth: width, clientHeight: height } = place;
      // What is not shown has no size.
      if (width * height > 0) {
        setPaper((last) =>
          last.width === width && last.height === height ? last : { width, height },
        );
      }
    };
    measure();
    const watch = new ResizeObserver(measure);
    watch.observe(place);
    return () => watch.disconnect();
  }, []);

  const point = ({ clientX, clientY }: PointerEvent) => ({ across: clientX, down: clientY });

  const takeBack = () => {
    if (held.current === undefined) return;
    const { turns, hasMoved, look } = held.current;
    held.current = undefined;
    if (!hasMoved) return;
    if (turns === "body") onCancelled?.();
    else onLook(look);
  };

  const move = (turns: "view" | "body", right: number, down: number, by: "drag" | "key") => {
    if (turns === "body") onTurn?.(turnAsSeen(camera, right, down), by);
    // What is in front follows the hand, so the eye goes the other way.
    else onLook(orbited(look, -right, down));
  };

  return (
    // The one role that leaves the arrow keys to the drawing.
    <div
      ref={stage}
      class={`stage ${onTurn ? "stage-turns" : ""}`}
      role="application"
      aria-roledescription={words.role}
      aria-label={label}
      aria-describedby={describedBy}
      // biome-ignore lint/a11y/noNoninteractiveTabindex: an application takes the keys.
      tabIndex={0}
      onKeyDown={(event) => {
        if (event.ctrlKey || event.metaKey || event.altKey) return;
        if (event.key === "Escape" && held.current?.turns === "body") {
          const { id } = held.current;
          takeBack();
          event.currentTarget.releasePointerCapture(id);
          return;
        }
        const arrow = arrows[event.key];
        const roll = rolls[event.key];
        if (arrow) {
          const [right, down] = arrow;
          const turns = event.shiftKey ? "body" : "view";
          move(turns, right * degreesPerPress, down * degreesPerPress, "key");
        } else if (roll !== undefined && onTurn) {
          onTurn(rollAsSeen(camera, roll * degreesPerPress), "key");
        } else return;
        event.preventDefault();
      }}
      onPointerDown={(event) => {
        // A second finger makes the picture, or the page, larger.
        if (!event.isPrimary) takeBack();
        if (event.button !== 0 || !event.isPrimary || held.current) return;
        const isBody = (event.target as Element).closest(".picture-body") !== null;
        held.current = {
          id: event.pointerId,
          ...point(event),
          turns: isBody && onTurn ? "body" : "view",
          hasMoved: false,
          look,
        };
        event.currentTarget.setPointerCapture(event.pointerId);
      }}
      onTouchStart={({ target }) =>
        keepFinger(target as SVGElement, () => held.current?.turns === "body")
      }
      onPointerMove={(event) => {
        const from = held.current;
        if (from?.id !== event.pointerId) return;
        const to = point(event);
        held.current = { ...from, ...to };
        const [right, down] = [to.across - from.across, to.down - from.down];
        if (right === 0 && down === 0) return;
        held.current.hasMoved = true;
        move(from.turns, right * degreesPerPixel, down * degreesPerPixel, "drag");
      }}
      // The browser makes a scroll of it.
      onPointerCancel={takeBack}
      onLostPointerCapture={() => {
        if (held.current?.turns === "body") onTurned?.();
        held.current = undefined;
      }}
    >
      <svg viewBox={`0 0 ${paper.width} ${paper.height}`} aria-hidden="true">
        <Drawing scene={scene} camera={camera} />
      </svg>
    </div>
  );
}
